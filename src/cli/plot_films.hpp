#pragma once

#include <string>

#include "engine/ledger/stored_sweep.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// Draws `spec`, of kind trajectories, from the files beside the table. Throws InputNotFound where one is missing,
/// IoError where one is not of this table, and what plot_trajectories() throws.
void plot_films(const StoredSweep& stored, const PlotSpec& spec, const std::string& table, const std::string& file);

}  // namespace sigmasweep
