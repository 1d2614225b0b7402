#include "sigmasweep/solve/exact.hpp"

#include <cmath>
#include <limits>

#include "exact_column.hpp"
#include "in_si.hpp"
#include "sigmasweep/scene/real.hpp"

namespace sigmasweep {

template <class Real>
Outcome<Real> exact_collision(const Column<Real>& column, const ExactOptions& options) {
  return ExactColumn<Real, 0>(column, options).run();
}
template Outcome<double> exact_collision(const Column<double>&, const ExactOptions&);
template Outcome<long double> exact_collision(const Column<long double>&, const ExactOptions&);
template Outcome<Quad> exact_collision(const Column<Quad>&, const ExactOptions&);

namespace {

/// One disturbance is one random draw of what the true error is another draw of: the factor makes it an error bar that
/// holds for 99.9 % of random tuples, at a median of about 30 times the true error.
constexpr double safety = 16.0;
/// Roundings of eps_eff itself, from velocities to energies.
constexpr double last_roundings = 5.0;
/// Contact events beyond which the wide types, 20 and 1000 times slower, are not tried.
constexpr std::uint64_t wide_limit = 20'000;

/// The collision computed in `Real`, its error bar included.
template <class Real>
Collision computed_in(const Parameters& p, const ExactOptions& options) {
  using std::abs;
  ExactColumn<Real, 1> exact(reduced_column<Real>(p), options);
  const Outcome<Real> outcome = exact.run();
  Collision c = in_si(outcome, p);
  if (c.status != Status::ok) return c;
  const Real rounding = std::numeric_limits<Real>::epsilon();
  const Real error = safety * abs(exact.eps_eff_disturbed()[0]) + last_roundings * rounding * Real(c.eps_eff) +
                     residual_dissipation<Real>(outcome.velocity, Real(1));
  c.eps_eff_error = static_cast<double>(error) + 0.5 * std::numeric_limits<double>::epsilon() * c.eps_eff;
  return c;
}

/// Where the result hangs on digits that nobody has, another column that differs from this one in the tenth digit
/// gives another draw of it. The linearised disturbance says nothing more there.
double spread(const Parameters& p, const ExactOptions& options, double eps_eff) {
  Column<double> other = reduced_column<double>(p);
  other.gap *= 1.0 + 1e-10;
  const Outcome<double> outcome = exact_collision(other, options);
  if (outcome.status != Status::ok) return 1.0;
  const double difference = std::abs(energies<double>(outcome.velocity, 1.0).eps_eff - eps_eff);
  return std::max(eps_eff, safety * difference);
}

}  // namespace

Collision simulate_exact(const Parameters& p) {
  ExactOptions options;
  options.settle = 1e-3 * p.tolerance;
  Collision c = computed_in<double>(p, options);
  if (c.status != Status::ok || c.eps_eff_error <= p.tolerance) return c;

  const auto gain = [](auto wide) {
    using Wide = decltype(wide);
    return std::numeric_limits<double>::epsilon() / static_cast<double>(std::numeric_limits<Wide>::epsilon());
  };
  const double wanted = c.eps_eff_error / p.tolerance;
  if (c.contacts <= wide_limit && wanted < gain(Quad())) {
    const Collision wide = wanted < gain(1.0L) ? computed_in<long double>(p, options) : computed_in<Quad>(p, options);
    if (wide.status != Status::ok || wide.eps_eff_error <= p.tolerance) return wide;
  }
  c.eps_eff_error = std::min(1.0, std::min(c.eps_eff_error, spread(p, options, c.eps_eff)));
  c.status = c.eps_eff_error <= p.tolerance ? Status::ok : Status::tolerance_missed;
  return c;
}

}  // namespace sigmasweep
