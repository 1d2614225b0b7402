#pragma once

#include <span>
#include <string>

#include "plot/figure/figure.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep::plot {

/// A figure as one page of HTML, which needs nothing else: zoom, curves on and off, and a point tells its row, its
/// error and the command that repeats it. `rows` are those that the figure was made of.
std::string html_page(const Figure& figure, std::span<const Row> rows, const PlotSpec& spec);

}  // namespace sigmasweep::plot
