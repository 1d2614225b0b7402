#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// Draws rows as the spec's [plot] says, by gnuplot; the ending of `path` (svg, png, pdf) chooses the form. Axes are
/// labelled in the paper's symbols with units, one series per distinct value of plot.series, hard spheres as dashed
/// lines. Throws UsageError (ending, unknown field), OutputError (gnuplot missing or failing).
void plot_rows(std::span<const Row> rows, const PlotSpec& plot, const std::string& title, const std::string& path);

}  // namespace sigmasweep
