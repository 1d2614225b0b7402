#include "engine_compute.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/sweep/cost.hpp"

namespace sigmasweep {
namespace {

/// CPU time of the calling thread, s; 0 if the system has no such clock.
double thread_seconds() {
  timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Collision simulate_or_fail(const Parameters& parameters, Patience& patience) noexcept {
  try {
    return simulate(parameters, &patience);
  } catch (...) {
    Collision failed;
    failed.status = Status::failed;
    return failed;
  }
}

}  // namespace

double time_limit_of(const Parameters& parameters) { return std::max(60.0, 100.0 * predicted_time(parameters)); }

std::optional<Row> compute_row(const Tuple& tuple, int rank, std::optional<double> limit,
                               std::function<bool()> to_end) noexcept {
  Row row{.index = tuple.index, .parameters = tuple.parameters, .collision = {}, .timing = {}};
  row.timing.rank = rank;
  row.timing.predicted_time = predicted_time(tuple.parameters);
  const double start = thread_seconds();
  Patience patience(limit ? *limit : time_limit_of(tuple.parameters), std::move(to_end));
  row.collision = simulate_or_fail(tuple.parameters, patience);
  if (patience.was_stopped()) return std::nullopt;
  row.timing.run_time = thread_seconds() - start;
  return row;
}

}  // namespace sigmasweep
