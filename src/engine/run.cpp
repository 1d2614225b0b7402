#include "engine/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "base/exit_codes.hpp"
#include "engine/compute_row.hpp"
#include "engine/distribute/distribute.hpp"
#include "engine/ledger/ledger.hpp"
#include "engine/report/progress.hpp"
#include "engine/report/provenance.hpp"
#include "engine/report/summary.hpp"
#include "engine/report/unstable_rows.hpp"
#include "engine/stop/deadline.hpp"
#include "engine/stop/slurm_job.hpp"
#include "engine/stop/stop.hpp"
#include "engine/trajectories/trajectories.hpp"
#include "engine/trajectories/trajectory_files.hpp"
#include "mpi/on_root.hpp"
#include "mpi/run_collective.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/cost.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/crash_notes.hpp"
#include "store/table/table.hpp"

namespace sigmasweep {
namespace {

using namespace exit_code;

constexpr int dedicated_manager_from = 17;  // ranks: what a manager that only manages may cost, 6 %

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The run on one rank. Every member function is called on all ranks alike, except those that say otherwise.
class Run {
 public:
  Run(World& world, const RunOptions& options)
      : world_(world),
        options_(options),
        table_(options.output.empty() ? default_table(options.spec) : options.output) {}

  int operator()() {
    if (const int code = begin(); code != success) return code;
    if (const int code = keep_time(); code != success) return code;
    if (world_.broadcast(std::int64_t{ledger_ && ledger_->table_is_complete()}) == 0) {
      if (const int code = keep_notes(); code != success) return code;
      if (const int code = compute(); code != success) return code;
      if (const int code = write(); code != success) return code;
    }
    if (const int code = film(); code != success) return code;
    return run_on_root(world_, [this] { return finish(); });
  }

 private:
  int begin();
  int keep_time();
  int keep_notes();
  int compute();
  int write();
  int film();
  int finish();               // on the manager
  Schedule schedule() const;  // on the manager
  void take(const Row& row);  // on the manager
  bool manager_computes() const;
  std::uint64_t rows() const { return options_.slice.size(sweep_->size()); }  // to be in the table

  void say(const std::string& what) const {
    if (!options_.quiet) std::fputs(what.c_str(), stderr);  // if nobody can read it, the run goes on
  }

  World& world_;
  const RunOptions& options_;
  StopRequest stop_;
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  const std::string table_, start_ = utc_now();
  std::optional<Sweep> sweep_;
  std::optional<CrashNotes> crash_notes_;
  // the manager's:
  std::optional<Ledger> ledger_;
  std::optional<Deadline> deadline_;
  std::optional<Progress> progress_;
  std::exception_ptr trouble_;  // with the journal, while rows came in
  Work work_;
  double wall_seconds_ = 0.0;
};

int Run::begin() {
  const int code = run_on_root(world_, [this] {
    sweep_ = Sweep::load(options_.spec);
    if (!options_.fresh) require_own_trajectories(*sweep_, table_);
    ledger_.emplace(*sweep_, table_,
                    LedgerOptions{options_.fresh, options_.slice, options_.extend, options_.reuse, options_.retry});
    if (options_.fresh) remove_trajectories(*sweep_, table_);
    for (const std::string& remark : ledger_->remarks()) say(fmt::format("sigmasweep: {}\n", remark));
    if (ledger_->table_is_complete())
      say(fmt::format("sigmasweep: {} is complete, nothing to compute (--fresh starts again)\n", table_));
    else if (ledger_->kept() > 0)
      say(fmt::format("sigmasweep: going on with {} of {} rows{}\n", ledger_->kept(), rows(),
                      ledger_->taken() ? fmt::format(", {} of them taken over", ledger_->taken()) : ""));
    return success;
  });
  if (code != success) return code;
  const std::string text = world_.broadcast(sweep_ ? sweep_->text() : "");
  if (!sweep_) sweep_ = Sweep::parse(text, options_.spec);
  return success;
}

/// Sees to it that everything ends before --max-time is over and before the Slurm job is.
int Run::keep_time() {
  constexpr double forever = std::numeric_limits<double>::infinity();
  double seconds = forever;
  const int code = run_on_root(world_, [&] {
    const SlurmJob job = ask_slurm();
    if (!job.warning.empty()) std::fputs(fmt::format("sigmasweep: {}\n", job.warning).c_str(), stderr);
    const double left = options_.max_seconds.value_or(forever) - seconds_since(begun_);
    seconds = std::min(left, job.seconds_left.value_or(forever));
    if (std::isfinite(seconds)) seconds -= time_for_the_end(seconds, double(rows()) * double(sizeof(Row)));
    if (job.seconds_left)
      say(fmt::format("sigmasweep: job {} ends in {}\n", job.id, readable_duration(*job.seconds_left)));
    return success;
  });
  if (code != success) return code;
  seconds = world_.broadcast(seconds);
  if (!std::isfinite(seconds)) return success;
  stop_.end_in(seconds);
  const double crowding = world_.crowding();
  if (!world_.is_manager()) return success;
  deadline_.emplace(stop_.end(), crowding);
  for (const Row& row : ledger_->rows()) deadline_->learn(row.timing);
  return success;
}

/// From here on what a run dies of can be known to the next one; and rows of which that is known are not tried again.
int Run::keep_notes() {
  constexpr std::uint64_t too_much = 4;  // two runs that died of this row, for all that is known
  CrashNotesIdentity identity{sweep_->hash(), sweep_->size(), std::random_device{}()};
  identity.run = static_cast<std::uint64_t>(world_.broadcast(static_cast<std::int64_t>(identity.run)));
  const bool forget = options_.fresh || options_.retry;
  const int code = run_on_root(world_, [&] {
    for (const auto& [row, blame] : begin_crash_notes(table_, identity, world_.size(), forget)) {
      if (blame < too_much || ledger_->has(row)) continue;
      ledger_->quarantine({row, sweep_->at(row)});
      say(fmt::format("sigmasweep: row {} is left out, processes died while they computed it (--retry tries again)\n",
                      row));
    }
    return success;
  });
  if (code != success) return code;
  try {
    run_collective(world_.comm(), [&] {
      crash_notes_.emplace(table_, identity, world_.rank());
      return std::uint64_t{0};
    });
  } catch (const Error& error) {  // the same on all ranks; the manager's is enough
    if (world_.is_manager()) throw;
    return error.exit_code();
  }
  return success;
}

bool Run::manager_computes() const {
  const ManagerRole role = sweep_->manager();
  return world_.size() == 1 || role == ManagerRole::computes ||
         (role == ManagerRole::automatic && world_.size() < dedicated_manager_from);
}

Schedule Run::schedule() const {
  auto rows = ledger_->missing();
  std::vector<double> seconds;
  seconds.reserve(rows.size());
  for (const std::uint64_t row : rows) seconds.push_back(predicted_time(sweep_->at(row)));
  return Schedule(std::move(rows), std::move(seconds), manager_computes() ? world_.size() : world_.size() - 1);
}

int Run::compute() {
  std::optional<Schedule> to_do;
  const int ready = run_on_root(world_, [&] {
    if (const std::string warning = stability_warning(*sweep_); !warning.empty())
      say(fmt::format("sigmasweep: {}\n", warning));
    to_do.emplace(schedule());
    progress_.emplace(rows() - ledger_->kept(), to_do->total_seconds(), world_.size(), options_.quiet);
    return success;
  });
  if (ready != success) return ready;

  Job<SweepTask, Row> job;
  job.task = [this](std::uint64_t row, double predicted_seconds) {
    return SweepTask{row, predicted_seconds, sweep_->at(row)};
  };
  job.compute = [this](const SweepTask& task, const std::function<bool()>& should_end) {
    crash_notes_->begin(task.index);
    const auto row = compute_row(task, world_.rank(), sweep_->tuple_time_limit(), should_end);
    crash_notes_->end();
    return row;
  };
  job.finished = [this](const Row& row) { take(row); };
  job.stop = [this] {
    if (progress_) progress_->add(0, 0.0);
    if (stop_.made()) crash_notes_->absolve();
    return trouble_ || stop_.made();
  };
  if (deadline_) job.max_seconds = [this] { return deadline_->max_seconds(); };
  job.manager_computes = manager_computes();
  const auto start = std::chrono::steady_clock::now();
  distribute(world_, to_do ? &*to_do : nullptr, job);
  wall_seconds_ = seconds_since(start);

  return run_on_root(world_, [this] {
    progress_->finish();
    end_crash_notes(table_, ledger_->is_complete());
    if (trouble_) std::rethrow_exception(trouble_);
    ledger_->sync();
    if (ledger_->is_complete()) return success;
    std::fputs(fmt::format("sigmasweep: stopped on purpose with {} of {} rows done{}; run it again{} to go on\n",
                           ledger_->there(), rows(), stop_.made() ? "" : ", the others would not end in time",
                           options_.fresh ? " without --fresh" : "")
                   .c_str(),
               stderr);
    return stopped;
  });
}

void Run::take(const Row& row) {
  if (trouble_) return;
  try {
    ledger_->enter(row);
    work_.add(row);
    if (deadline_) deadline_->learn(row.timing);
    progress_->add(1, row.timing.predicted_time);
  } catch (...) {
    trouble_ = std::current_exception();  // stops the run
  }
}

int Run::write() {
  TableInfo info = table_info(*sweep_, start_, world_.size());  // the manager's counts
  info.slice = options_.slice;
  const auto block = world_.scatter(ledger_ ? ledger_->rows() : std::vector<Row>{}, rows());
  try {
    write_table(world_.comm(), table_, info, sweep_->columns(), rows(), world_.block(rows()).first, block);
  } catch (const Error& error) {  // the same on all ranks; the manager's is enough
    if (world_.is_manager()) throw;
    return error.exit_code();
  }
  return success;
}

/// Trajectories, if the spec wants some. The table is there, and a stop or an error from here on leaves it alone.
int Run::film() {
  const int closed = run_on_root(world_, [this] { return ledger_->close(), success; });
  if (closed != success || !sweep_->trajectory() || !options_.slice.is_whole()) return closed;
  Films films;
  try {
    films = write_trajectories(world_, *sweep_, table_, ledger_ ? ledger_->rows() : std::vector<Row>{}, stop_);
  } catch (const Error& error) {  // the same on all ranks; the manager's is enough
    if (world_.is_manager()) throw;
    return error.exit_code();
  }
  return run_on_root(world_, [&] {
    const std::string where = trajectory_directory(table_);
    if (films.there == films.wanted) {
      say(fmt::format("sigmasweep: {} trajectories in {}\n", films.there, where));
      return success;
    }
    std::fputs(fmt::format("sigmasweep: stopped on purpose with {} of {} trajectories in {}; run it again{} to go on\n",
                           films.there, films.wanted, where, options_.fresh ? " without --fresh" : "")
                   .c_str(),
               stderr);
    return stopped;
  });
}

int Run::finish() {
  say(fmt::format("{}: {}", table_, summary(ledger_->rows(), work_, world_.size(), wall_seconds_)));
  const bool fine = std::all_of(ledger_->rows().begin(), ledger_->rows().end(),
                                [](const Row& row) { return is_success(row.result.status); });
  return fine ? success : some_rows_failed;
}

}  // namespace

std::string default_table(const std::string& spec) {
  return std::filesystem::path(spec).filename().replace_extension(".h5").string();
}

int run(World& world, const RunOptions& options) { return Run(world, options)(); }

}  // namespace sigmasweep
