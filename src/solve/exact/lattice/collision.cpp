#include "solve/exact/lattice/collision.hpp"

#include <algorithm>
#include <cmath>

#include "solve/exact/lattice/events.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/to_si.hpp"
#include "solve/twin_runs.hpp"

namespace sigmasweep {
namespace {

template <class Real>
double eps_eff(const Lattice<Real>& lattice, const LatticeOutcome<Real>& outcome) {
  return double(energies(lattice, outcome.velocity).eps_eff);
}

template <class Real>
SimulationResult result(const Parameters& p, const Lattice<Real>& lattice, const LatticeOutcome<Real>& outcome) {
  return to_si_result(energies(lattice, outcome.velocity), outcome, p);
}

/// The change of eps_eff that the runs' velocities would make if its parts had random signs. Runs of a collision that
/// is chaotic may well have the same eps_eff by chance, but not the same velocities; without losses it is no chance.
template <class Real>
double apart(const Lattice<Real>& lattice, const LatticeOutcome<Real>& one, const LatticeOutcome<Real>& other) {
  if (lattice.beads.C == 0 && lattice.beads.C_wall == 0 && lattice.D_t == 0) return 0.0;
  double squares = 0.0, energy = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < lattice.count(); ++i) {
    const auto m = static_cast<double>(lattice.mass(i));
    const Vec2<Real> v = one.velocity[i], change = other.velocity[i] - v;
    squares += std::pow(m * double(v.x * change.x), 2) + std::pow(m * double(v.z * change.z), 2);
    energy += m * double(dot(v, v));
    mass += m;
  }
  return energy > 0.0 ? std::sqrt(squares / (energy * mass)) / double(lattice.beads.speed) : 0.0;
}

/// How far the runs' velocities are apart, a mass-weighted root mean square over v0.
template <class Real>
double distance(const Lattice<Real>& lattice, const LatticeOutcome<Real>& one, const LatticeOutcome<Real>& other) {
  double squares = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < lattice.count(); ++i) {
    const Vec2<Real> change = other.velocity[i] - one.velocity[i];
    squares += double(lattice.mass(i) * dot(change, change));
    mass += double(lattice.mass(i));
  }
  return std::sqrt(squares / mass) / double(lattice.beads.speed);
}

/// Uncertainty of eps_eff because the moment of the end is uncertain: late contacts of slow beads come at times that
/// are chaotic before eps_eff is. The runs' longest waits say by how much the times are uncertain, and which of the
/// waits may be on the other side of quiet_time().
template <class Real>
double ending_uncertainty(const Lattice<Real>& lattice, const LatticeOutcome<Real>& one,
                          const LatticeOutcome<Real>& other) {
  const auto &waits = one.waits.longest, &others = other.waits.longest;
  double unknown = 0.0, change = 0.0;
  for (std::size_t k = 0; k < waits.size(); ++k)
    unknown = std::max(unknown, std::fabs(double(waits[k].length - others[k].length)));
  for (const auto& wait : waits)
    if (wait.length > 0 && std::fabs(double(wait.length - lattice.quiet_time())) <= chance * unknown)
      change = std::max(change, double(wait.change));
  return change;
}

/// Larger local errors hardly save time, and in rows of beads side by side are motions that do not settle.
constexpr double coarsest = 1e-8;

}  // namespace

template <class Real>
LatticeOutcome<Real> lattice_collision(const Lattice<Real>& lattice, double accuracy, const RunLimits& limits) {
  NullObserver nobody;
  return LatticeEvents<Real>(lattice, accuracy, limits).run(nobody);
}
template LatticeOutcome<double> lattice_collision(const Lattice<double>&, double, const RunLimits&);
template LatticeOutcome<long double> lattice_collision(const Lattice<long double>&, double, const RunLimits&);

void observe_lattice(const Lattice<double>& lattice, LatticeSamples& samples) {
  LatticeEvents<double>(lattice, 1e-12, {}).run(samples);
}

SimulationResult simulate_lattice(const Parameters& p, ComputeBudget* budget) {
  return refine_until(p.tolerance, coarsest, [&]<class Real>(double local_error) {
    const RunLimits limits{.settle = 1e-3 * p.tolerance, .budget = budget};
    const Lattice<Real> lattice = reduced_lattice<Real>(p);
    using Outcome = LatticeOutcome<Real>;
    const auto solve = [&](double accuracy) { return lattice_collision(lattice, accuracy, limits); };
    const auto to_result = [&](const Outcome& outcome) { return result(p, lattice, outcome); };
    const auto difference = [&](const Outcome& outcome, const Outcome& other) {
      return std::max(std::fabs(eps_eff(lattice, other) - eps_eff(lattice, outcome)),
                      apart(lattice, outcome, other) / chance);
    };
    const auto of_velocities = [&](const Outcome& outcome, const Outcome& other) {
      return distance(lattice, outcome, other);
    };
    const auto unseen = [&](const SimulationResult& c, const Outcome& outcome, const Outcome& other) {
      // Both runs have the same positions after long flights, and what these cannot resolve does not differ.
      const double from_nothing = std::max(c.eps_eff - 1.0, 0.0);
      return Unseen{.late = double(outcome.remainder) + ending_uncertainty(lattice, outcome, other),
                    .places = double(lattice.rounding()) + from_nothing};
    };
    return run_with_error_bars(local_error, solve, to_result, difference, of_velocities, unseen);
  });
}

}  // namespace sigmasweep
