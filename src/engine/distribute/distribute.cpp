#include "engine/distribute/distribute.hpp"

#include "engine/distribute/manager.hpp"
#include "engine/distribute/remote_worker.hpp"

namespace sigmasweep {

void distribute_bytes(const World& world, Schedule* schedule, const ByteJob& job) {
  if (world.is_manager())
    Manager(world, *schedule, job).run();
  else
    work_remotely(world, job);
}

}  // namespace sigmasweep
