#pragma once

#include <span>

namespace sigmasweep {

/// Energy ratios of final velocities. Masses as in Column: empty if all are 1.
template <class Real>
struct Energies {
  Real eps_eff{}, Er_Ef{}, Er_E0{}, v_cm{};  ///< as in SimulationResult; v_cm over the initial speed
};
template <class Real>
Energies<Real> energies(std::span<const Real> velocity, Real speed, std::span<const Real> mass = {});

/// How far two sets of velocities are apart: the root mean square of the differences, weighted with the masses.
template <class Real>
Real distance(std::span<const Real> velocity, std::span<const Real> other, std::span<const Real> mass = {});

/// The projection Pv onto the cone 0 <= w_1 <= ... <= w_N, by pooling adjacent violators (isotonic regression) in one
/// pass; norms are weighted with the masses. Why the cone: every completed contact hands momentum upwards
/// (int F dt = K int x^(1+beta) dt >= 0, as x starts and ends at 0), and at the end nothing approaches. So the final
/// velocities lie in the cone, and differ from today's by an element of its polar cone; by Moreau's decomposition their
/// norm is at least |Pv|.
template <class Real>
struct Projection {
  Real lost{}, kept{};  ///< |v - Pv|^2 and |Pv|^2, each without cancellation
};
template <class Real>
Projection<Real> project_on_separated(std::span<const Real> velocity, std::span<const Real> mass = {});

/// Largest amount by which eps_eff can still fall when all contacts are open and the beads have these velocities.
template <class Real>
Real residual_dissipation(std::span<const Real> velocity, Real speed, std::span<const Real> mass = {});

}  // namespace sigmasweep
