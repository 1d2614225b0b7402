#include "engine/phases/record_trajectories.hpp"

#include <fmt/format.h>

#include "engine/phases/phase.hpp"
#include "engine/trajectories/trajectories.hpp"
#include "engine/trajectories/trajectory_files.hpp"

namespace sigmasweep {

bool record_trajectories(const World& world, OpenSweep& open, const StopRequest& stop, const Reporter& reporter) {
  on_manager(world, [&] { open.ledger->close(); });
  if (!open.sweep.trajectory()) return true;
  if (!open.slice.is_whole()) {
    on_manager(world,
               [&] { reporter.say("a slice has no trajectories: 'run' without --slice records them after 'merge'"); });
    return true;
  }
  TrajectoryCount count;
  RowSource rows(0, {});
  on_manager(world, [&] { rows = open.table_rows(); });
  on_all_ranks(world, [&] { count = write_trajectories(world, open.sweep, open.table, rows, stop); });
  on_manager(world, [&] {
    const std::string where = trajectory_directory(open.table);
    if (count.written == count.wanted)
      reporter.say(fmt::format("{} trajectories in {}", count.written, where));
    else
      reporter.warn(fmt::format("stopped on purpose with {} of {} trajectories in {}; {} to go on", count.written,
                                count.wanted, where, open.restart_hint()));
  });
  return count.written == count.wanted;
}

}  // namespace sigmasweep
