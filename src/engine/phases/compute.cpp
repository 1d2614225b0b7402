#include "engine/phases/compute.hpp"

#include <fmt/format.h>

#include <exception>
#include <utility>
#include <vector>

#include "base/duration.hpp"
#include "engine/compute_batch.hpp"
#include "engine/distribute/distribute.hpp"
#include "engine/phases/give_up.hpp"
#include "engine/phases/phase.hpp"
#include "engine/report/progress.hpp"
#include "engine/report/remarks.hpp"
#include "mpi/run_collective.hpp"
#include "sigmasweep/solve/cost.hpp"
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

/// Takes in the rows that come from the workers. On the manager.
class RowIntake {
 public:
  RowIntake(const Sweep& sweep, Ledger& ledger, Deadline* deadline, Progress progress, RunNotes& notes)
      : sweep_(sweep), ledger_(ledger), deadline_(deadline), progress_(std::move(progress)), notes_(notes) {}

  /// Does not throw: what goes wrong with the journal ends the run, and is thrown by finish().
  void take(std::span<const SweepAnswer> answers) {
    if (error_) return;
    try {
      std::vector<Row> rows;
      rows.reserve(answers.size());
      for (const auto& [index, result, timing] : answers) rows.push_back({index, sweep_.at(index), result, timing});
      ledger_.enter(rows);
      double predicted = 0.0;
      for (const Row& row : rows) {
        work_.add(row);
        if (deadline_) deadline_->learn(row.timing);
        predicted += row.timing.predicted_time;
      }
      progress_.add(rows.size(), predicted);
    } catch (...) {
      error_ = std::current_exception();
    }
  }

  /// Whether the run cannot go on. Lets the progress bar, the notes and the journal see the time.
  bool poll() {
    progress_.add(0, 0.0);
    notes_.tell(progress_.now());
    try {
      if (!error_) ledger_.check_journal();
    } catch (...) {
      error_ = std::current_exception();
    }
    return error_ != nullptr;
  }

  void finish() {
    progress_.finish();
    if (error_) std::rethrow_exception(error_);
    ledger_.sync();
  }

  const Work& work() const { return work_; }

 private:
  const Sweep& sweep_;
  Ledger& ledger_;
  Deadline* deadline_;
  Progress progress_;
  RunNotes& notes_;
  Work work_;
  std::exception_ptr error_;
};

using SweepJob = Job<SweepTask, SweepAnswer>;

SweepJob sweep_job(const World& world, const Sweep& sweep, BatchComputer& computer, RunNotes& notes,
                   const StopRequest& stop, std::optional<RowIntake>& intake) {
  SweepJob job;
  job.task = [&](std::uint64_t row, double predicted_seconds) {
    return SweepTask{row, predicted_seconds, sweep.at(row)};
  };
  job.batch_size = [&](std::span<const SweepTask> tasks) { return computer.size(tasks); };
  job.compute_batch = [&](std::span<const SweepTask> batch, const std::function<bool()>& should_end,
                          std::vector<SweepAnswer>& answers) { computer.compute(batch, should_end, answers); };
  job.finished = [&](std::span<const SweepAnswer> answers) { intake->take(answers); };
  job.stop = [&] {
    const bool failed = intake && intake->poll();
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
  BatchComputer computer(world.rank(), open.sweep.tuple_time_limit(), noted.suspects(), notes);
  std::optional<Schedule> schedule;
  std::optional<RowIntake> intake;
  SweepJob job = sweep_job(world, open.sweep, computer, notes, stop, intake);
  if (deadline) job.max_seconds = [&] { return deadline->max_seconds(); };
  job.silent = [&](const std::vector<SilentRank>& silent) { give_up(silent, open, reporter); };
  on_manager(world, [&] {
    const std::uint64_t missing = open.rows() - open.ledger->kept();
    announce(reporter, missing, world.size());
    for (const std::string& remark : remarks_on(open.sweep)) reporter.say(remark);
    schedule.emplace(schedule_of(*open.ledger, open.sweep, job.manager_computes ? world.size() : world.size() - 1));
    intake.emplace(open.sweep, *open.ledger, deadline ? &*deadline : nullptr,
                   Progress(missing, schedule->total_seconds(), reporter), notes);
  });
  const auto start = std::chrono::steady_clock::now();
  const double begun_after = std::chrono::duration<double>(start - open.steady_start).count();
  distribute(world, schedule ? &*schedule : nullptr, job);
  Computed computed;
  computed.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::uint64_t nanoseconds =
      run_collective(world.comm(), [&] { return static_cast<std::uint64_t>(1e9 * computer.computing_seconds()); });
  on_manager(world, [&] {
    intake->finish();
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
