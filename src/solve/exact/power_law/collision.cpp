#include "solve/exact/power_law/collision.hpp"

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "assembly/energies.hpp"
#include "solve/exact/power_law/column.hpp"
#include "solve/to_si.hpp"
#include "solve/twin_runs.hpp"

namespace sigmasweep {

template <class Real>
Outcome<Real> nonlinear_collision(const Column<Real>& column, double accuracy, const RunLimits& limits,
                                  double restitution_off) {
  return NonlinearColumn<Real>(column, accuracy, limits, {}, restitution_off).run();
}
template Outcome<double> nonlinear_collision(const Column<double>&, double, const RunLimits&, double);
template Outcome<long double> nonlinear_collision(const Column<long double>&, double, const RunLimits&, double);

namespace {

template <class Real>
double eps_eff(const Column<Real>& column, const Outcome<Real>& outcome) {
  return double(energies<Real>(outcome.velocity, column.speed, column.mass).eps_eff);
}

/// Of a wide type: the work (contacts in trial steps) of about a second.
constexpr std::uint64_t long_double_limit = 150'000;

}  // namespace

SimulationResult simulate_nonlinear(const Parameters& p, ComputeBudget* budget) {
  return refine_until(p.tolerance, 1.0, [&]<class Real>(double local_error) {
    RunLimits limits{.settle = 1e-3 * p.tolerance, .budget = budget};
    if (!std::is_same_v<Real, double>) limits.work_limit = long_double_limit;
    const Column<Real> column = reduced_column<Real>(p);
    const auto solve = [&](double accuracy) {
      // Isolated contacts have the same errors in both runs: in the second one an error of its accuracy is added.
      return nonlinear_collision(column, accuracy, limits, accuracy > local_error ? accuracy : 0.0);
    };
    const auto to_result = [&](const Outcome<Real>& outcome) {
      return to_si_result(outcome, p, std::span<const Real>(column.mass));
    };
    const auto difference = [&](const Outcome<Real>& outcome, const Outcome<Real>& other) {
      return std::fabs(eps_eff(column, other) - eps_eff(column, outcome));
    };
    const auto apart = [&](const Outcome<Real>& outcome, const Outcome<Real>& other) {
      return double(distance<Real>(outcome.velocity, other.velocity, column.mass) / column.speed);
    };
    const auto unseen = [&](const SimulationResult&, const Outcome<Real>& outcome, const Outcome<Real>&) {
      return Unseen{.late = outcome.end == End::settled ? limits.settle : 0.0};
    };
    return run_with_error_bars(local_error, solve, to_result, difference, apart, unseen);
  });
}

void observe_nonlinear(const Column<double>& column, Samples& samples) {
  NonlinearColumn<double>(column, 1e-12, {.settle = 0.0}).run(samples);  // to the last sample
}

}  // namespace sigmasweep
