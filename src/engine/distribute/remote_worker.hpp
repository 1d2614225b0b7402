#pragma once

#include "engine/distribute/byte_job.hpp"
#include "mpi/world.hpp"

namespace sigmasweep {

/// Works on a rank of its own until the manager, on rank 0, says quit.
void work_remotely(const World& world, const ByteJob& job);

}  // namespace sigmasweep
