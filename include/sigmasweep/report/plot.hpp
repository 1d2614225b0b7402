#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// Draws rows as the spec's [plot] says, by gnuplot; the ending of `path` (svg, png, pdf) chooses the form. Axes are
/// labelled in the paper's symbols with units, one series per distinct value of plot.series, hard spheres as dashed
/// lines. What cannot be drawn (failed rows, nothing positive for a logarithmic axis) is counted in a note on the plot.
/// The picture is complete or not there. Throws UsageError (ending, unknown field), OutputError (gnuplot missing or
/// failing, `path` cannot be written).
void plot_rows(std::span<const Row> rows, const PlotSpec& plot, const std::string& title, const std::string& path);

}  // namespace sigmasweep
