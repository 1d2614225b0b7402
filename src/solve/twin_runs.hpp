#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "sigmasweep/model/result.hpp"
#include "solve/to_si.hpp"

/// Error bars of collisions that are integrated with local errors of a given size: by the difference from a second run
/// with local errors ten times as large.
namespace sigmasweep {

/// Largest seen of (error - `chance` times the difference of the runs)/(local accuracy), for random tuples with N
/// to 20.
inline constexpr double amplification = 100.0;
/// Factor by which the difference of the two runs may be too small by chance.
inline constexpr double chance = 4.0;
/// Local accuracies that the number types can keep.
inline constexpr double finest_double = 1e-15, finest_long_double = 1e-19;
/// Of the next finer accuracy: below that which would just do, and the most and the least of a change at a time.
inline constexpr double safety = 0.1, farthest = 1e-4, nearest = 0.1;

/// Errors of eps_eff that the difference of two runs does not show.
struct Unseen {
  double late = 0.0;    ///< by contacts after the end
  double places = 0.0;  ///< by positions that are rounded the same way in both
};

/// The collision with local errors of `accuracy`, its error bars from a second run with ten times as much:
///     Outcome solve(accuracy)                       one run
///     SimulationResult to_result(outcome)           the result that it means, without errors
///     double difference(outcome, other)             of eps_eff, between two runs that have come to an end
///     double distance(outcome, other)               of their velocities, a mass-weighted root mean square over v0
///     Unseen unseen(result, outcome, other)
/// A second run without an end differs by 1.
template <class Solve, class ToResult, class Difference, class Distance, class UnseenOf>
SimulationResult run_with_error_bars(double accuracy, Solve&& solve, ToResult&& to_result, Difference&& difference,
                                     Distance&& distance, UnseenOf&& unseen) {
  const auto outcome = solve(accuracy);
  SimulationResult c = to_result(outcome);
  if (c.status != Status::ok) return c;
  const auto other = solve(accuracy * 10.0);
  const bool both_end = other.status == Status::ok;
  const auto [late, places] = unseen(c, outcome, other);
  const auto error = [&](double apart, double left) {
    return chance * apart + amplification * accuracy + left + std::numeric_limits<double>::epsilon() * c.eps_eff +
           places;
  };
  c.eps_eff_error = error(both_end ? difference(outcome, other) : 1.0, late);
  set_errors_of_motion(c, error(both_end ? distance(outcome, other) : 1.0, velocity_left(c.eps_eff, late)));
  return c;
}

/// SimulationResult run.operator()<Real>(accuracy), a collision with eps_eff_error, is called until that meets the
/// tolerance: with ever finer accuracies, `coarsest` or finer, in doubles as long as these keep them, then in long
/// double. Status::tolerance_missed with the smallest error found where none meets it.
template <class Run>
SimulationResult refine_until(double tolerance, double coarsest, Run&& run) {
  double accuracy = std::min(std::max(1e-3 * tolerance, finest_double), coarsest);
  SimulationResult last = run.template operator()<double>(accuracy), best = last;
  const auto is_wanting = [&] { return last.status == Status::ok && last.eps_eff_error > tolerance; };
  // What the error grew to from the local accuracy says how fine that must be. But where the runs have their events in
  // another order, or none of them has converged, they differ by more than that; and by rounding, at the finest.
  double growth = last.eps_eff_error / accuracy;
  const auto wanted = [&] { return safety * tolerance / growth; };
  const auto refine = [&]<class Real>(double finest) {
    accuracy = std::max(std::clamp(wanted(), farthest * accuracy, nearest * accuracy), finest);
    last = run.template operator()<Real>(accuracy);
    const double seen = last.eps_eff_error / accuracy;
    growth = accuracy > finest ? seen : std::min(seen, growth);
    if (last.status == Status::ok && last.eps_eff_error < best.eps_eff_error) best = last;
  };
  while (is_wanting() && accuracy > 2.0 * finest_double) refine.template operator()<double>(finest_double);
  while (is_wanting() && wanted() >= finest_long_double) refine.template operator()<long double>(finest_long_double);
  if (best.status == Status::ok && best.eps_eff_error > tolerance) {
    best.eps_eff_error = std::min(1.0, best.eps_eff_error);
    best.status = Status::tolerance_missed;
  }
  return best;
}

}  // namespace sigmasweep
