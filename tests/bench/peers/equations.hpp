#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bench/peers/tuples.hpp"

/// The column as one writes it down for a library of ODE solvers, in reduced units: mass of a bead 1, time in tc,
/// length in v0 tc. All that is known at compile time is, as it makes the solvers twice as fast.
namespace sigmasweep::peers {

/// Overlaps x of the contacts (< 0: a gap), then their rates u = x'. Contact 0 is that of the wall and the lowest bead.
/// Overlaps and not positions: small ones keep their digits, and an event sets one to exactly 0.
using State = std::array<double, 2 * beads>;

/// The column before the collision: all gaps sigma, all velocities -1.
State at_start(double sigma);

/// Which contacts are closed: 1, else 0.
using Closed = std::array<double, beads>;

/// Force of a closed contact over the mass of a bead, K x + C u; Eqs. (2), (3), (6), (7), and the same for the wall:
///   mu = -ln eps,  omega0^2 = pi^2 + mu^2,  K = omega0^2/2,  C = mu    (reduced mass 1/2, m_ij = 1).
struct ContactForce {
  double K, C;
  explicit ContactForce(double eps);
};

/// The right-hand side with forces F: x_0'' = F_1 - F_0, x_k'' = F_{k-1} - 2 F_k + F_{k+1}.
inline void accelerate(const Closed& force, std::span<const double, 2 * beads> y, std::span<double, 2 * beads> rate) {
  for (std::size_t k = 0; k < beads; ++k) rate[k] = y[beads + k];
  rate[beads] = force[1] - force[0];
  for (std::size_t k = 1; k + 1 < beads; ++k) rate[beads + k] = force[k - 1] - 2.0 * force[k] + force[k + 1];
  rate[2 * beads - 1] = force[beads - 2] - 2.0 * force[beads - 1];
}

/// Between events: it is given which contacts are closed.
struct BetweenEvents {
  ContactForce law{epsilon};
  Closed closed{};
  void operator()(const State& y, State& rate, double) const {
    Closed force;
    for (std::size_t k = 0; k < beads; ++k) force[k] = closed[k] * (law.K * y[k] + law.C * y[beads + k]);
    accelerate(force, y, rate);
  }
};

/// Without events: contacts are closed whose overlaps are positive.
struct WithoutEvents {
  ContactForce law{epsilon};
  void operator()(const State& y, State& rate, double) const {
    Closed force;
    for (std::size_t k = 0; k < beads; ++k) force[k] = y[k] > 0.0 ? law.K * y[k] + law.C * y[beads + k] : 0.0;
    accelerate(force, y, rate);
  }
};

/// eps_eff if the collision ended in this state.
double eps_eff(const State& y);

/// Whether it is over, all contacts being open: later contacts can change eps_eff by no more than `settle`. Without
/// this bound, which sigmasweep uses, too, a column with sigma = 0 would go on for a million t_c.
bool is_over(const State& y, double settle);

/// The time until the first of the open contacts closes when no force acts; infinite if none does.
double time_to_closing(const State& y);

}  // namespace sigmasweep::peers
