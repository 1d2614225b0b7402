#pragma once

#include <span>
#include <string>

#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Draws how the beads of vibrated lattices circulate: for each lattice and each quarter of the plate's period the mean
/// velocities in cells of about one diameter, over all periods but the first third (or the transient, if that is less),
/// in the frame of the plate and vertically relative to the mean at that height. Written below: what the longest arrow
/// is, and the mean curl in the left and in the right half, 1/s: a pair of convection rolls that goes up in the middle
/// has left > 0 > right. Lattices that differ only in parameters to average over (as the seed) are one: their beads
/// make one field, and the curl is the mean of theirs with its standard error. `axes`: the parameters that tell rows
/// apart; `path` and errors as of plot_trajectories(); UsageError for what does not vibrate.
void plot_velocity_fields(std::span<const Panel> panels, std::span<const std::string> axes,
                          std::span<const std::string> mean_over, const std::string& title, const std::string& path);

}  // namespace sigmasweep
