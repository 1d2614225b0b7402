#include "engine/compute_row.hpp"

#include <algorithm>
#include <utility>

#include "base/thread_clock.hpp"
#include "sigmasweep/solve/simulate.hpp"

namespace sigmasweep {

std::optional<Row> compute_row(const SweepTask& task, int rank, std::optional<double> limit,
                               std::function<bool()> should_end) noexcept {
  Row row{.index = task.index, .parameters = task.parameters, .result = {}, .timing = {}};
  row.timing.rank = rank;
  row.timing.predicted_time = task.predicted_seconds;
  const double start = thread_seconds();
  ComputeBudget budget(limit ? *limit : default_time_limit(task.predicted_seconds), std::move(should_end));
  row.result = simulate(task.parameters, &budget);
  if (budget.was_stopped()) return std::nullopt;
  row.timing.run_time = thread_seconds() - start;
  return row;
}

double default_time_limit(double predicted_seconds) { return std::max(60.0, 100.0 * predicted_seconds); }

}  // namespace sigmasweep
