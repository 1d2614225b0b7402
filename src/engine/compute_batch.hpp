#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/run_notes/run_notes.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// A hundred times the predicted time, but at least a minute, s.
double default_time_limit(double predicted_seconds);

/// Computes rows on one rank: several side by side where their solver can (Solver::run_many), others one by one. Both
/// have the bits of simulate(). Whatever a solver throws becomes Status::failed.
///
/// The CPU clock, which is a system call, is read once a batch. The rows of a batch share its CPU time: rows that are
/// computed one by one in proportion to the time that each took by the steady clock, rows side by side in proportion to
/// their predicted times. Rows that drop out of a batch, because they take longer, are computed and timed alone.
class BatchComputer {
 public:
  using ParametersOf = std::function<Parameters(std::uint64_t row)>;
  /// A row that takes longer than `limit` of CPU time, s, becomes Status::time_limit; by default the limit is
  /// default_time_limit(). `alone` are rows of which a process may have died: none of them is computed in a batch with
  /// others, so that only the guilty one is blamed. `parameters_of` gives the parameters of a row.
  BatchComputer(int rank, std::optional<double> limit, std::set<std::uint64_t> alone, RunNotes& notes,
                ParametersOf parameters_of);

  /// The number of the first of `tasks` that make a batch.
  std::size_t size(std::span<const ScheduledTask> tasks) const;
  /// Computes the first tasks of a batch and appends their rows, without their attempts. It ends after a few
  /// milliseconds if the rows take longer than predicted, but not before the first row, unless `should_end` says so.
  void compute(std::span<const ScheduledTask> batch, const std::function<bool()>& should_end, std::vector<Row>& rows);
  /// Time by the clock that was spent on rows, s.
  double computing_seconds() const { return seconds_; }

 private:
  using Clock = RunNotes::Clock;
  struct Task : ScheduledTask {
    Parameters parameters;
  };
  bool is_alone(const ScheduledTask& task) const { return !alone_.empty() && alone_.contains(task.row); }
  bool goes_side_by_side(const ScheduledTask& task) const;
  ComputeBudget budget_of(const Task& task, const std::function<bool()>& should_end) const;
  Row row_of(const Task& task, const SimulationResult& result, double seconds) const;
  void one_by_one(std::span<const Task> batch, const std::function<bool()>& should_end, std::vector<Row>& rows);
  void side_by_side(std::span<const Task> batch, const std::function<bool()>& should_end, std::vector<Row>& rows);

  int rank_;
  std::optional<double> limit_;
  std::set<std::uint64_t> alone_;
  RunNotes& notes_;
  ParametersOf parameters_of_;
  double seconds_ = 0.0;
};

}  // namespace sigmasweep
