#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "sigmasweep/model/result.hpp"

/// Error bars of what is integrated with local errors of a given size: by a second run with ten times as large ones.
namespace sigmasweep {

/// Largest seen of (error - `doubt` times the difference of the runs)/(local accuracy), for random tuples with N to 20.
inline constexpr double amplification = 100.0;
/// How much the difference between the runs may be too small by chance.
inline constexpr double doubt = 4.0;
/// Local accuracies that the types can make good.
inline constexpr double finest_double = 1e-15, finest_long_double = 1e-19;

/// What two runs' eps_eff, which differ by `difference`, are worth; `left`: what the runs left out at the end.
inline double twin_error(const SimulationResult& c, double difference, double accuracy, double left) {
  return doubt * difference + amplification * accuracy + left + std::numeric_limits<double>::epsilon() * c.eps_eff;
}

/// SimulationResult run.operator()<Real>(accuracy), a collision with eps_eff_error, is called until that meets the
/// tolerance: with ever finer accuracies, in long double in the end. Status::tolerance_missed with the smallest error
/// found where none meets it.
template <class Run>
SimulationResult to_tolerance(double tolerance, Run&& run) {
  double accuracy = std::max(1e-3 * tolerance, finest_double);
  SimulationResult c = run.template operator()<double>(accuracy);
  if (c.status != Status::ok || c.eps_eff_error <= tolerance) return c;

  // What the error grew to from the local accuracy says how fine that must be.
  const auto wanted = [&] { return 0.2 * accuracy * tolerance / c.eps_eff_error; };
  const auto is_better = [&](const SimulationResult& finer) {
    if (finer.status == Status::ok && finer.eps_eff_error < c.eps_eff_error) c = finer;
    return c.eps_eff_error <= tolerance;
  };
  if (wanted() >= finest_double) {
    accuracy = wanted();
    if (is_better(run.template operator()<double>(accuracy))) return c;
  }
  if (wanted() >= finest_long_double) {
    accuracy = wanted();
    if (is_better(run.template operator()<long double>(accuracy))) return c;
  }
  c.eps_eff_error = std::min(1.0, c.eps_eff_error);
  c.status = Status::tolerance_missed;
  return c;
}

}  // namespace sigmasweep
