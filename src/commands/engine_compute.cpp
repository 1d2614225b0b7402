#include "engine_compute.hpp"

#include <ctime>

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

Collision simulate_or_fail(const Parameters& parameters) noexcept {
  try {
    return simulate(parameters);
  } catch (...) {
    Collision failed;
    failed.status = Status::failed;
    return failed;
  }
}

}  // namespace

Row compute_row(const Tuple& tuple, int rank) noexcept {
  Row row{.index = tuple.index, .parameters = tuple.parameters, .collision = {}, .timing = {}};
  row.timing.rank = rank;
  row.timing.predicted_time = predicted_time(tuple.parameters);
  const double start = thread_seconds();
  row.collision = simulate_or_fail(tuple.parameters);
  row.timing.run_time = thread_seconds() - start;
  return row;
}

}  // namespace sigmasweep
