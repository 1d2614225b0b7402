#pragma once

#include <span>
#include <string>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// Where the schemes of fixed step are stable: what theory says (stability.hpp) beside what the rows of a table show.
namespace sigmasweep {

/// The first map among a spec's plots, or one with defaults.
PlotSpec stability_plot(std::span<const PlotSpec> plots);

/// A map of the rows with a given time step for each combination of the other axes: the step dt/tc against the plot's y
/// (a parameter). Squares are rows, coloured by how far eps_eff, of what vibrates the energy balance, is off; crosses
/// came out unstable; the line is the limit that theory predicts. `axes`: those of the sweep. Throws as plot_rows()
/// does, and UsageError where no row has a time step or there are more than max_stability_maps maps.
inline constexpr std::size_t max_stability_maps = 48;
void plot_stability(std::span<const Row> rows, const PlotSpec& plot, std::span<const std::string> axes,
                    const std::string& title, const std::string& path);

/// The same as text: for each y the longest step up to which all rows are stable, the shortest that is not, and the
/// predicted limit; and on how many rows theory and collision agree. Throws UsageError.
std::string stability_text(std::span<const Row> rows, const PlotSpec& plot, std::span<const std::string> axes);

}  // namespace sigmasweep
