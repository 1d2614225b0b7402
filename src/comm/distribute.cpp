#include "manager.hpp"
#include "sigmasweep/comm/world.hpp"
#include "worker.hpp"

namespace sigmasweep {

void distribute(const World& world, Schedule* schedule, const Job& job) {
  if (world.is_manager()) Manager(world, *schedule, job).run();
  else work_remotely(world, job);
}

}  // namespace sigmasweep
