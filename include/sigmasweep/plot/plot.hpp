#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The line that is fitted to a series of a plot (see FitSpec).
struct SeriesFit {
  std::string series;  ///< "epsilon = 0.6"
  double slope = 0.0;
  double slope_error = 0.0;  ///< standard error; NaN for two points
  double prefactor = 0.0;    ///< A of y = A x^slope, or the value of a line at x = 0
  std::uint64_t points = 0;
};

/// Draws rows with gnuplot as the plot's spec says. The ending of `path` (svg, png, pdf) chooses the form; html is an
/// interactive page, gp the commands of gnuplot with their data, csv the points. Axes have
/// the paper's symbols and units. There is a series for each combination of values of plot.series. If soft and hard
/// spheres both occur, hard ones are dashed lines, or symbols with error bars. Fitted lines are thin, with their slopes
/// in the key; guides are dashed. A note on the plot counts the rows that cannot be drawn, because they failed or are
/// not positive on a logarithmic axis. The picture is complete or not there. Throws UsageError (ending, unknown field,
/// bad expression) and OutputError (gnuplot is missing or fails, `path` cannot be written). Returns the fits, without
/// hard spheres that are drawn as lines.
std::vector<SeriesFit> plot_rows(std::span<const Row> rows, const PlotSpec& plot, const std::string& title,
                                 const std::string& path);

/// The fits as an indented text table; empty if there are none.
std::string fit_table(std::span<const SeriesFit> fits, const FitSpec& spec);

}  // namespace sigmasweep
