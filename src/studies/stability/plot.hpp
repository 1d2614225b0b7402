#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// Largest number of maps in a picture.
inline constexpr std::size_t max_stability_maps = 48;

/// Draws maps of the rows with a given time step: the step dt/tc against the plot's y, a parameter, one map for each
/// combination of the other axes. Squares are rows, coloured by the error of eps_eff, or of the energy balance where a
/// plate vibrates; crosses are unstable rows; the line is the limit that theory predicts. `axes`: those of the sweep.
/// Throws as plot_rows() does, and UsageError where no row has a time step or there are more than max_stability_maps
/// maps.
void plot_stability(std::span<const Row> rows, const PlotSpec& plot, std::span<const std::string> axes,
                    const std::string& title, const std::string& path);

}  // namespace sigmasweep
