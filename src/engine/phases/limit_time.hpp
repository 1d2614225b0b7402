#pragma once

#include <optional>

#include "engine/phases/open.hpp"
#include "engine/stop/deadline.hpp"
#include "engine/stop/stop.hpp"

namespace sigmasweep {

/// Second phase: sees to it that the run ends before `max_seconds` after its start are over, and before the Slurm job
/// does. Then `stop` has its end on each rank, and the manager a Deadline.
std::optional<Deadline> limit_time(const World& world, const OpenSweep& open, std::optional<double> max_seconds,
                                   StopRequest& stop, const Reporter& reporter);

}  // namespace sigmasweep
