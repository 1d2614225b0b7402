#include "engine/distribute/manager.hpp"
#include "engine/distribute/worker.hpp"
#include "mpi/world.hpp"

namespace sigmasweep {

void distribute(const World& world, Schedule* schedule, const Job& job) {
  if (world.is_manager())
    Manager(world, *schedule, job).run();
  else
    work_remotely(world, job);
}

}  // namespace sigmasweep
