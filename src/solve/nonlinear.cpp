#include "sigmasweep/solve/nonlinear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "in_si.hpp"
#include "nonlinear_column.hpp"

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

/// Largest seen of (error - `doubt` times the difference of the runs)/(local accuracy), for random tuples with N to 20.
constexpr double amplification = 100.0;
/// How much the difference between the runs may be too small by chance.
constexpr double doubt = 4.0;
/// Local accuracies that the types can make good, and the work (contacts in trial steps) of about a second in the wide
/// one.
constexpr double finest_double = 1e-15, finest_long_double = 1e-19;
constexpr std::uint64_t long_double_limit = 150'000;

/// The collision with local errors of `accuracy`, its error from a second run with ten times as much.
template <class Real>
Collision pair_of_runs(const Parameters& p, const NonlinearOptions& options) {
  const Column<Real> column = reduced_column<Real>(p);
  NonlinearOptions coarse = options;
  coarse.accuracy *= 10.0;
  const Outcome<Real> outcome = nonlinear_collision(column, options);
  Collision c = in_si(outcome, p, std::span<const Real>(column.mass));
  if (c.status != Status::ok) return c;
  const Outcome<Real> other = nonlinear_collision(column, coarse);
  const double difference =
      other.status == Status::ok ? std::fabs(eps_eff(column, other) - eps_eff(column, outcome)) : 1.0;
  const double settled = outcome.end == End::settled ? options.settle : 0.0;
  c.eps_eff_error = doubt * difference + amplification * options.accuracy + settled +
                    std::numeric_limits<double>::epsilon() * c.eps_eff;
  return c;
}

}  // namespace

Collision simulate_nonlinear(const Parameters& p, Patience* patience) {
  NonlinearOptions options;
  options.patience = patience;
  options.settle = 1e-3 * p.tolerance;
  options.accuracy = std::max(1e-3 * p.tolerance, finest_double);
  Collision c = pair_of_runs<double>(p, options);
  if (c.status != Status::ok || c.eps_eff_error <= p.tolerance) return c;

  // What the error grew to from the local accuracy says how fine that must be.
  const auto wanted = [&] { return 0.2 * options.accuracy * p.tolerance / c.eps_eff_error; };
  const auto is_better = [&](const Collision& finer) {
    if (finer.status == Status::ok && finer.eps_eff_error < c.eps_eff_error) c = finer;
    return c.eps_eff_error <= p.tolerance;
  };
  if (wanted() >= finest_double) {
    options.accuracy = wanted();
    if (is_better(pair_of_runs<double>(p, options))) return c;
  }
  if (wanted() >= finest_long_double) {
    options.accuracy = wanted();
    options.work_limit = long_double_limit;
    if (is_better(pair_of_runs<long double>(p, options))) return c;
  }
  c.eps_eff_error = std::min(1.0, c.eps_eff_error);
  c.status = Status::tolerance_missed;
  return c;
}

}  // namespace sigmasweep
