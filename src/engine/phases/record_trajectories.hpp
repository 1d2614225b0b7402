#pragma once

#include "engine/phases/open.hpp"
#include "engine/stop/stop.hpp"

namespace sigmasweep {

/// Sixth phase, once the table is there: gives up the journal, and records the trajectories that the spec chooses. A
/// stop or an error from here on leaves the table alone. Returns false where trajectories are missing because of a
/// stop. Throws as write_trajectories().
bool record_trajectories(const World& world, OpenSweep& open, const StopRequest& stop, const Reporter& reporter);

}  // namespace sigmasweep
