#pragma once

#include "engine/report/reporter.hpp"
#include "engine/run_options.hpp"
#include "mpi/world.hpp"

namespace sigmasweep {

/// `sigmasweep run`, on all ranks; the same exit code on each: 0 all rows fine, 3 some rows have no result, 75
/// stopped on purpose. An Error is thrown on the manager alone, the other ranks return its exit code: one message, no
/// rank waits.
///
/// The phases of a run are functions of their own in engine/phases: open_sweep(), limit_time(), NotedRun,
/// compute_rows(), write_rows(), record_trajectories(), report_rows().
int run_sweep(const World& world, const RunOptions& options, const Reporter& reporter);
/// The same with messages on stderr.
int run(World& world, const RunOptions& options);

}  // namespace sigmasweep
