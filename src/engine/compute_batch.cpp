#include "engine/compute_batch.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/thread_clock.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/solvers.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t most_rows = 256;
/// Predicted time of a batch, s: what a stop may have to wait for, and what cannot be given back to another rank.
constexpr double longest_side_by_side = 0.1, longest_one_by_one = 0.01;
constexpr auto patience = std::chrono::milliseconds(5);  // with rows one by one
/// With those rows of a batch that cannot go side by side after all. What others have been computed is done again.
constexpr auto patience_with_slow_rows = std::chrono::milliseconds(100);

double seconds(std::chrono::nanoseconds time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

double default_time_limit(double predicted_seconds) { return std::max(60.0, 100.0 * predicted_seconds); }

BatchComputer::BatchComputer(int rank, std::optional<double> limit, std::set<std::uint64_t> alone, RunNotes& notes,
                             ParametersOf parameters_of)
    : rank_(rank), limit_(limit), alone_(std::move(alone)), notes_(notes), parameters_of_(std::move(parameters_of)) {}

bool BatchComputer::goes_side_by_side(const ScheduledTask& task) const {
  return solver_of(parameters_of_(task.row)).run_many != nullptr;
}

std::size_t BatchComputer::size(std::span<const ScheduledTask> tasks) const {
  const ScheduledTask& first = tasks.front();
  if (is_alone(first)) return 1;
  const bool is_side_by_side = goes_side_by_side(first);
  const double longest = is_side_by_side ? longest_side_by_side : longest_one_by_one;
  double predicted = first.predicted_seconds;
  std::size_t size = 1;
  for (const ScheduledTask& task : tasks.first(std::min(tasks.size(), most_rows)).subspan(1)) {
    predicted += task.predicted_seconds;
    if (predicted > longest || is_alone(task) || goes_side_by_side(task) != is_side_by_side) break;
    ++size;
  }
  return size;
}

void BatchComputer::compute(std::span<const ScheduledTask> batch, const std::function<bool()>& should_end,
                            std::vector<Row>& rows) {
  const auto start = Clock::now();
  std::vector<Task> tasks;
  tasks.reserve(batch.size());
  for (const ScheduledTask& task : batch) tasks.push_back({task, parameters_of_(task.row)});
  if (batch.size() > 1 && goes_side_by_side(batch.front()))
    side_by_side(tasks, should_end, rows);
  else
    one_by_one(tasks, should_end, rows);
  notes_.end();
  seconds_ += seconds(Clock::now() - start);
}

ComputeBudget BatchComputer::budget_of(const Task& task, const std::function<bool()>& should_end) const {
  return ComputeBudget(limit_ ? *limit_ : default_time_limit(task.predicted_seconds),
                       [&should_end] { return should_end(); });
}

Row BatchComputer::row_of(const Task& task, const SimulationResult& result, double seconds) const {
  return {.index = task.row,
          .parameters = task.parameters,
          .result = result,
          .timing = {.run_time = seconds, .predicted_time = task.predicted_seconds, .rank = rank_}};
}

void BatchComputer::one_by_one(std::span<const Task> batch, const std::function<bool()>& should_end,
                               std::vector<Row>& rows) {
  const double cpu_start = thread_seconds();
  const auto start = Clock::now();
  const std::size_t before = rows.size();
  auto now = start;
  for (const Task& task : batch) {
    notes_.begin({&task.row, 1}, now);
    ComputeBudget budget = budget_of(task, should_end);
    const SimulationResult result = simulate(task.parameters, &budget);
    const auto began = std::exchange(now, Clock::now());
    if (budget.was_stopped()) break;
    rows.push_back(row_of(task, result, seconds(now - began)));
    if (now - start > patience) break;
  }
  const double all = seconds(now - start), factor = all > 0.0 ? (thread_seconds() - cpu_start) / all : 1.0;
  for (Row& row : std::span(rows).subspan(before)) row.timing.run_time *= factor;
}

void BatchComputer::side_by_side(std::span<const Task> batch, const std::function<bool()>& should_end,
                                 std::vector<Row>& rows) {
  std::vector<std::uint64_t> indices;
  std::vector<Parameters> parameters;
  for (const Task& task : batch) {
    indices.push_back(task.row);
    parameters.push_back(task.parameters);
  }
  std::vector<SimulationResult> results(batch.size());
  const double start = thread_seconds();
  notes_.begin(indices);
  simulate_together(parameters, results);
  double predicted = 0.0;
  for (const Task& task : batch) predicted += task.predicted_seconds;
  const double share = (thread_seconds() - start) / predicted;
  const auto began = Clock::now();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    double needed = batch[i].predicted_seconds * share;
    if (results[i].status == Status::not_run) {
      if (Clock::now() - began > patience_with_slow_rows) return;  // the rest is put back
      const double alone = thread_seconds();
      notes_.begin({&indices[i], 1});
      ComputeBudget budget = budget_of(batch[i], should_end);
      results[i] = simulate(parameters[i], &budget);
      if (budget.was_stopped()) return;
      needed += thread_seconds() - alone;
    }
    rows.push_back(row_of(batch[i], results[i], needed));
  }
}

}  // namespace sigmasweep
