#include "engine/run.hpp"

#include "base/exit_codes.hpp"
#include "engine/phases/compute.hpp"
#include "engine/phases/give_up.hpp"
#include "engine/phases/limit_time.hpp"
#include "engine/phases/note_run.hpp"
#include "engine/phases/open.hpp"
#include "engine/phases/phase.hpp"
#include "engine/phases/record_trajectories.hpp"
#include "engine/phases/report.hpp"
#include "engine/phases/write.hpp"
#include "engine/stop/last_resort.hpp"
#include "engine/stop/stop.hpp"

namespace sigmasweep {
namespace {

int run_phases(const World& world, const RunOptions& options, const Reporter& reporter) {
  StopRequest stop;
  OpenSweep open = open_sweep(world, options, reporter);
  std::optional<Deadline> deadline = limit_time(world, open, options.max_seconds, stop, reporter);
  Computed computed;
  bool finished = open.table_is_complete;
  if (!finished) {
    NotedRun noted(world, open, reporter);
    LastResort::prepare_by([table = open.table] { return give_up_without_manager(table); },
                           [table = open.table] { return is_some_rank_silent(table); });
    computed = compute_rows(world, open, noted, deadline, stop, reporter);
    finished = computed.is_complete;
    if (finished) write_rows(world, open);
  }
  if (finished) finished = record_trajectories(world, open, stop, reporter);
  if (options.json) return report_as_json(world, open, computed, finished, reporter);
  return finished ? report_rows(world, open, computed, reporter) : exit_code::stopped;
}

}  // namespace

int run_sweep(const World& world, const RunOptions& options, const Reporter& reporter) {
  try {
    return run_phases(world, options, reporter);
  } catch (const FailedOnManager& failure) {
    return failure.exit_code;
  }
}

int run(World& world, const RunOptions& options) {
  return run_sweep(world, options, Reporter::on_stderr(options.quiet));
}

}  // namespace sigmasweep
