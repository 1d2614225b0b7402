#include "solve/exact/power_law/collision.hpp"

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "solve/exact/power_law/column.hpp"
#include "solve/to_si.hpp"
#include "solve/twin_runs.hpp"

namespace sigmasweep {

template <class Real>
Outcome<Real> nonlinear_collision(const Column<Real>& column, const NonlinearOptions& options) {
  return NonlinearColumn<Real>(column, options).run();
}
template Outcome<double> nonlinear_collision(const Column<double>&, const NonlinearOptions&);
template Outcome<long double> nonlinear_collision(const Column<long double>&, const NonlinearOptions&);

namespace {

template <class Real>
double eps_eff(const Column<Real>& column, const Outcome<Real>& outcome) {
  return double(energies<Real>(outcome.velocity, column.speed, column.mass).eps_eff);
}

/// Of a wide type: the work (contacts in trial steps) of about a second.
constexpr std::uint64_t long_double_limit = 150'000;

/// The collision with local errors of `accuracy`, its error from a second run with ten times as much.
template <class Real>
SimulationResult pair_of_runs(const Parameters& p, const NonlinearOptions& options) {
  const Column<Real> column = reduced_column<Real>(p);
  NonlinearOptions coarse = options;
  coarse.accuracy *= 10.0;
  const Outcome<Real> outcome = nonlinear_collision(column, options);
  SimulationResult c = to_si_result(outcome, p, std::span<const Real>(column.mass));
  if (c.status != Status::ok) return c;
  const Outcome<Real> other = nonlinear_collision(column, coarse);
  const double difference =
      other.status == Status::ok ? std::fabs(eps_eff(column, other) - eps_eff(column, outcome)) : 1.0;
  const double settled = outcome.end == End::settled ? options.settle : 0.0;
  c.eps_eff_error = twin_error(c, difference, options.accuracy, settled);
  return c;
}

}  // namespace

SimulationResult simulate_nonlinear(const Parameters& p, ComputeBudget* budget) {
  return to_tolerance(p.tolerance, [&]<class Real>(double accuracy) {
    NonlinearOptions options;
    options.budget = budget;
    options.settle = 1e-3 * p.tolerance;
    options.accuracy = accuracy;
    if (!std::is_same_v<Real, double>) options.work_limit = long_double_limit;
    return pair_of_runs<Real>(p, options);
  });
}

void observe_nonlinear(const Column<double>& column, Samples& samples) {
  NonlinearOptions options;
  options.settle = 0.0;  // to the last sample
  NonlinearColumn<double>(column, options).run(samples);
}

}  // namespace sigmasweep
