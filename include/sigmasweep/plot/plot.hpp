#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The line fitted to one series of a plot (see FitSpec).
struct SeriesFit {
  std::string series;  ///< "epsilon = 0.6"
  double slope = 0.0;
  double slope_error = 0.0;  ///< standard error; NaN for two points
  double prefactor = 0.0;    ///< A of y = A x^slope; of a line its value at x = 0
  std::uint64_t points = 0;
};

/// Draws rows as the spec's [plot] says, by gnuplot; the ending of `path` (svg, png, pdf) chooses the form. Axes are
/// labelled in the paper's symbols with units, one series per distinct value of plot.series; where soft and hard
/// spheres both occur, the hard ones as dashed lines (as symbols where there are error bars). Fitted lines are thin,
/// their slopes in the key; guides are dashed. What cannot be drawn (failed rows, nothing positive for a logarithmic
/// axis) is counted in a note on the plot. The picture is complete or not there. Throws UsageError (ending, unknown
/// field, bad expression), OutputError (gnuplot missing or failing, `path` cannot be written). Returns the fits, hard
/// spheres drawn as lines left out.
std::vector<SeriesFit> plot_rows(std::span<const Row> rows, const PlotSpec& plot, const std::string& title,
                                 const std::string& path);

/// The fits as a small text table, indented; empty where there are none.
std::string fit_table(std::span<const SeriesFit> fits, const FitSpec& spec);

}  // namespace sigmasweep
