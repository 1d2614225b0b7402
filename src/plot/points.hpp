#pragma once

#include <span>
#include <string>

#include "plot/figure/figure.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep::plot {

/// The points of a figure as CSV: a line for each, with its curve, x, y, the length of its error bar and the number of
/// its row, which is empty for a mean of several.
std::string points_as_csv(const Figure& figure, std::span<const Row> rows, const PlotSpec& spec);

}  // namespace sigmasweep::plot
