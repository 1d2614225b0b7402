#include "engine/distribute/manager.hpp"
#include "mpi/world.hpp"
#include "engine/distribute/worker.hpp"

namespace sigmasweep {

void distribute(const World& world, Schedule* schedule, const Job& job) {
  if (world.is_manager()) Manager(world, *schedule, job).run();
  else work_remotely(world, job);
}

}  // namespace sigmasweep
