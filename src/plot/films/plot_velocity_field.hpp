#pragma once

#include <span>
#include <string>

#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Draws the velocity field of vibrated lattices, a frame for each quarter of the plate's period (see VelocityField).
/// Below each frame stand the velocity of the longest arrow, m/s, and the mean curl in the left and in the right half,
/// 1/s (see Rolls). Lattices that differ only in the parameters `mean_over`, such as the seed, share one field; their
/// curl is the mean of the single ones with its standard error. `axes` are the parameters that tell rows apart. `path`
/// and errors are those of plot_trajectories(); a panel without a plate is a UsageError.
void plot_velocity_fields(std::span<const Panel> panels, std::span<const std::string> axes,
                          std::span<const std::string> mean_over, const std::string& title, const std::string& path);

}  // namespace sigmasweep
