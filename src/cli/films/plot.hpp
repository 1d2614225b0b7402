#pragma once

#include <string>

#include "sigmasweep/sweep/sweep.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

/// Draws a plot of kind trajectories from the trajectory files beside the table. Throws InputNotFound if a file is
/// missing, IoError if it does not belong to the table, and the errors of plot_trajectories().
void plot_films(const StoredSweep& stored, const PlotSpec& spec, const std::string& table, const std::string& file);

}  // namespace sigmasweep
