#include "engine/compute.hpp"

#include <algorithm>
#include <utility>

#include "base/thread_clock.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/sweep/cost.hpp"

namespace sigmasweep {
double time_limit_of(const Parameters& parameters) { return std::max(60.0, 100.0 * predicted_time(parameters)); }

std::optional<Row> compute_row(const Tuple& tuple, int rank, std::optional<double> limit,
                               std::function<bool()> to_end) noexcept {
  Row row{.index = tuple.index, .parameters = tuple.parameters, .result = {}, .timing = {}};
  row.timing.rank = rank;
  row.timing.predicted_time = predicted_time(tuple.parameters);
  const double start = thread_seconds();
  ComputeBudget budget(limit ? *limit : time_limit_of(tuple.parameters), std::move(to_end));
  row.result = simulate(tuple.parameters, &budget);
  if (budget.was_stopped()) return std::nullopt;
  row.timing.run_time = thread_seconds() - start;
  return row;
}

}  // namespace sigmasweep
