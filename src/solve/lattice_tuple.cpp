#include <algorithm>
#include <cmath>

#include "in_si.hpp"
#include "sigmasweep/solve/lattice.hpp"
#include "twin_runs.hpp"

namespace sigmasweep {
namespace {

template <class Real>
double eps_eff(const Lattice<Real>& lattice, const LatticeOutcome<Real>& outcome) {
  return double(energies(lattice, outcome.velocity).eps_eff);
}

template <class Real>
Collision result(const Parameters& p, const Lattice<Real>& lattice, const LatticeOutcome<Real>& outcome) {
  return in_si_with(energies(lattice, outcome.velocity), outcome, p);
}

/// The collision with local errors of `accuracy`, its error from a second run with ten times as much.
template <class Real>
Collision pair_of_runs(const Parameters& p, const LatticeOptions& options) {
  const Lattice<Real> lattice = reduced_lattice<Real>(p);
  LatticeOptions coarse = options;
  coarse.accuracy *= 10.0;
  const LatticeOutcome<Real> outcome = lattice_collision(lattice, options);
  Collision c = result(p, lattice, outcome);
  if (c.status != Status::ok) return c;
  const LatticeOutcome<Real> other = lattice_collision(lattice, coarse);
  const double difference =
      other.status == Status::ok ? std::fabs(eps_eff(lattice, other) - eps_eff(lattice, outcome)) : 1.0;
  // Both runs have the same positions after long flights, and what these cannot resolve does not differ.
  const double from_nothing = std::max(c.eps_eff - 1.0, 0.0);
  c.eps_eff_error = twin_error(c, difference, options.accuracy, double(outcome.remainder)) +
                    double(lattice.rounding()) + from_nothing;
  return c;
}

/// Larger local errors hardly save time, and in rows of beads side by side are motions that do not settle.
constexpr double coarsest = 1e-8;

Collision exact(const Parameters& p, Patience* patience) {
  return to_tolerance(p.tolerance, [&]<class Real>(double accuracy) {
    return pair_of_runs<Real>(
        p, {.accuracy = std::min(accuracy, coarsest), .settle = 1e-3 * p.tolerance, .patience = patience});
  });
}

/// eps_eff_error: the distance to the exact solution, and the error of that.
Collision by_fixed_steps(const Parameters& p, Patience* patience) {
  const auto lattice = reduced_lattice<double>(p);
  Collision c = result(p, lattice, fixed_step_lattice_collision(lattice, p.integrator, 1.0 / p.steps_per_tc,
                                                                {.patience = patience}));
  if (c.status != Status::ok) return c;
  const Collision reference = exact(p, patience);
  const double error = std::fabs(c.eps_eff - reference.eps_eff) + reference.eps_eff_error;
  c.eps_eff_error = error <= 1.0 ? error : 1.0;  // also where there is no reference
  return c;
}

}  // namespace

Collision simulate_lattice(const Parameters& p, Patience* patience) {
  return p.integrator == Integrator::exact ? exact(p, patience) : by_fixed_steps(p, patience);
}

}  // namespace sigmasweep
