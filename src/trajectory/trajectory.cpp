#include "sigmasweep/trajectory/trajectory.hpp"

#include "solve/solvers.hpp"

namespace sigmasweep {

Trajectory record(const Parameters& parameters, std::span<const double> times) {
  return solver_of(parameters).observe(parameters, times);
}

double show_time(const Parameters& parameters, const SimulationResult& collision) {
  return solver_of(parameters).film_duration(parameters, collision);
}

std::vector<double> sample_times(double duration, std::size_t count) {
  std::vector<double> times(count);
  const double last = static_cast<double>(count - 1);
  for (std::size_t s = 0; s < count; ++s) times[s] = duration * (static_cast<double>(s) / last);
  return times;
}

}  // namespace sigmasweep
