#include "engine/phases/compute.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

#include "base/duration.hpp"
#include "engine/compute_batch.hpp"
#include "engine/distribute/distribute.hpp"
#include "engine/ledger/identity.hpp"
#include "engine/phases/give_up.hpp"
#include "engine/phases/phase.hpp"
#include "engine/report/progress.hpp"
#include "engine/report/remarks.hpp"
#include "engine/rows/row_keeper.hpp"
#include "mpi/run_collective.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "store/journal/names.hpp"
#include "store/run_notes/run_notes.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {
namespace {

/// Number of ranks from which on the manager only manages: that costs 6 % of the ranks at most.
constexpr int dedicated_manager_from = 17;

bool manager_computes(const World& world, const Sweep& sweep) {
  const ManagerRole role = sweep.manager();
  return world.size() == 1 || role == ManagerRole::computes ||
         (role == ManagerRole::automatic && world.size() < dedicated_manager_from);
}

/// Predicts the cost of each missing row, once. On the manager.
Schedule schedule_of(const Ledger& ledger, const Sweep& sweep, int ranks) {
  std::vector<ScheduledTask> tasks;
  tasks.reserve(ledger.missing());
  ledger.for_each_missing([&](std::uint64_t row) { tasks.push_back({row, predicted_time(sweep.at(row))}); });
  return Schedule(std::move(tasks), ranks);
}

/// Takes in what the ranks say of the rows that they have kept. On the manager.
class RowIntake {
 public:
  RowIntake(Ledger& ledger, Deadline* deadline, Progress progress, RunNotes& notes)
      : ledger_(ledger), deadline_(deadline), progress_(std::move(progress)), notes_(notes) {}

  /// Does not throw: what goes wrong ends the run, and is thrown by finish().
  void take(std::span<const RowDone> rows) {
    if (error_) return;
    try {
      ledger_.enter(rows);
      double predicted = 0.0;
      for (const RowDone& row : rows) {
        work_.add(row.run_time);
        if (deadline_) deadline_->learn({.run_time = row.run_time, .predicted_time = row.predicted_time});
        predicted += row.predicted_time;
      }
      progress_.add(rows.size(), predicted);
    } catch (...) {
      error_ = std::current_exception();
    }
  }

  /// Whether the run cannot go on. Lets the progress bar and the notes see the time.
  bool poll() {
    progress_.add(0, 0.0);
    notes_.tell(progress_.now());
    return error_ != nullptr;
  }

  void finish() {
    progress_.finish();
    if (error_) std::rethrow_exception(error_);
  }

  const Work& work() const { return work_; }

 private:
  Ledger& ledger_;
  Deadline* deadline_;
  Progress progress_;
  RunNotes& notes_;
  Work work_;
  std::exception_ptr error_;
};

/// The journal of a rank other than the manager.
JournalFile journal_of(const World& world, const OpenSweep& open) {
  const std::vector<Field> results = journalled_results(open.sweep);
  return {journal_of_rank(open.table, world.rank()), journal_identity(open.sweep, open.slice, results),
          open.info(world)};
}

using SweepJob = Job<ScheduledTask, RowDone>;

/// Computes a batch and keeps its rows; tells of those that are kept.
void compute_and_keep(std::span<const ScheduledTask> batch, const std::function<bool()>& should_end,
                      BatchComputer& computer, RowKeeper& keeper, std::vector<RowDone>& done) {
  if (keeper.has_failed()) return std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the end is under way
  std::vector<Row> rows;
  computer.compute(batch, should_end, rows);
  if (!keeper.keep(rows)) return;
  for (const Row& row : rows) done.push_back({row.index, row.timing.run_time, row.timing.predicted_time});
}

SweepJob sweep_job(const World& world, const Sweep& sweep, BatchComputer& computer, RowKeeper& keeper, RunNotes& notes,
                   const StopRequest& stop, std::optional<RowIntake>& intake) {
  SweepJob job;
  job.task = [](std::uint64_t row, double predicted_seconds) { return ScheduledTask{row, predicted_seconds}; };
  job.batch_size = [&](std::span<const ScheduledTask> tasks) { return computer.size(tasks); };
  job.compute_batch = [&](std::span<const ScheduledTask> batch, const std::function<bool()>& should_end,
                          std::vector<RowDone>& done) { compute_and_keep(batch, should_end, computer, keeper, done); };
  job.finished = [&](std::span<const RowDone> rows) { intake->take(rows); };
  job.stop = [&] {
    const bool failed = (intake && intake->poll()) || keeper.has_failed();
    if (stop.made()) notes.absolve();
    return failed || stop.made();
  };
  job.manager_computes = manager_computes(world, sweep);
  return job;
}

/// Why a run that began to compute so many seconds after its start ends without all rows, as part of a sentence; empty
/// if it was told to stop.
std::string why_stopped(const StopRequest& stop, const Computed& computed, double begun_after) {
  if (!stop.made()) return ", the others would not end in time";
  if (StopRequest::Clock::now() < stop.end() || computed.work.rows > 0) return {};
  if (computed.wall_seconds < 0.1)
    return fmt::format(", its time was over before the first: to begin took {}", readable_duration(begun_after));
  return fmt::format(", none of which within the {} there were: it needs a longer time limit",
                     readable_duration(computed.wall_seconds));
}

}  // namespace

Computed compute_rows(const World& world, OpenSweep& open, NotedRun& noted, std::optional<Deadline>& deadline,
                      const StopRequest& stop, const Reporter& reporter) {
  RunNotes& notes = noted.notes();
  BatchComputer computer(world.rank(), open.sweep.tuple_time_limit(), noted.suspects(), notes,
                         [&](std::uint64_t row) { return open.sweep.at(row); });
  std::optional<JournalFile> other_journal;
  if (!world.is_manager()) other_journal.emplace(journal_of(world, open));
  RowKeeper keeper(world.is_manager() ? open.ledger->journal() : *other_journal, open.attempts);
  std::optional<Schedule> schedule;
  std::optional<RowIntake> intake;
  SweepJob job = sweep_job(world, open.sweep, computer, keeper, notes, stop, intake);
  if (deadline) job.max_seconds = [&] { return deadline->max_seconds(); };
  job.silent = [&](const std::vector<SilentRank>& silent) { give_up(silent, open, reporter); };
  on_manager(world, [&] {
    const std::uint64_t missing = open.rows() - open.ledger->kept();
    announce(reporter, missing, world.size());
    for (const std::string& remark : remarks_on(open.sweep)) reporter.say(remark);
    schedule.emplace(schedule_of(*open.ledger, open.sweep, job.manager_computes ? world.size() : world.size() - 1));
    intake.emplace(*open.ledger, deadline ? &*deadline : nullptr,
                   Progress(missing, schedule->total_seconds(), reporter), notes);
  });
  const auto start = std::chrono::steady_clock::now();
  const double begun_after = std::chrono::duration<double>(start - open.steady_start).count();
  distribute(world, schedule ? &*schedule : nullptr, job);
  Computed computed;
  computed.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  on_manager(world, [&] { intake->finish(); });
  on_all_ranks(world, [&] {
    run_collective(world.comm(), [&] {
      keeper.finish();
      return std::uint64_t{0};
    });
  });
  const std::uint64_t nanoseconds =
      run_collective(world.comm(), [&] { return static_cast<std::uint64_t>(1e9 * computer.computing_seconds()); });
  on_manager(world, [&] {
    computed.work = intake->work();
    computed.work.computing_seconds = 1e-9 * static_cast<double>(nanoseconds);
    computed.is_complete = open.ledger->is_complete();
    if (computed.is_complete) return;
    reporter.warn(fmt::format("stopped on purpose with {} of {} rows done{}; {} to go on", open.ledger->there(),
                              open.rows(), why_stopped(stop, computed, begun_after), open.restart_hint()));
  });
  computed.is_complete = world.broadcast(std::int64_t{computed.is_complete}) != 0;
  return computed;
}

}  // namespace sigmasweep
