#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"

/// The problem that the solvers solve, in any consistent system of units with bead mass 1.
namespace sigmasweep {

/// A column of N equal beads, every gap `gap`, flying at `speed` into the wall. While contact k is closed (k = 1: the
/// wall and bead 1; k: beads k-1 and k) it pushes with F_k = K x_k + C x_k', x_k > 0 the overlap; Eqs. (2), (3).
/// Real is double, long double or a wider type.
template <class Real>
struct Column {
  std::int64_t N = 1;
  Real gap{};      ///< s0
  Real speed{};    ///< v0
  Real tc{};       ///< pair contact time, Eq. (6)
  Real eps{};      ///< pair restitution, Eq. (7)
  Real eps_wall{}; ///< wall restitution, for hard spheres
  Real K{}, C{};             ///< pair: spring K/m and dashpot D_n, both over the bead mass
  Real K_wall{}, C_wall{};   ///< wall

  /// Of contact k, counted from 0, the wall's.
  const Real& spring(std::size_t k) const { return k == 0 ? K_wall : K; }
  const Real& dashpot(std::size_t k) const { return k == 0 ? C_wall : C; }
};

/// The column in reduced units: time in tc, length in v0 tc. Only sigma, N and epsilon are left, nothing cancels.
template <class Real>
Column<Real> reduced_column(const Parameters& parameters);

/// The same column in raw SI units: the check that the reduction is right.
template <class Real>
Column<Real> si_column(const Parameters& parameters);

/// What a solver hands back, in the column's units.
template <class Real>
struct Outcome {
  std::vector<Real> velocity;  ///< final velocities of beads 1..N
  Real t_k{};                  ///< from the first to the last contact with the wall
  Real x_max{};                ///< largest overlap
  std::uint64_t contacts = 0;  ///< contacts closed and opened again
  End end = End::none;
  Status status = Status::ok;
};

/// The ratios that a set of final velocities means for `column`.
template <class Real>
struct Energies {
  Real eps_eff{}, Er_Ef{}, Er_E0{}, v_cm{};  ///< as in Collision; v_cm over the initial speed
};
template <class Real>
Energies<Real> energies(std::span<const Real> velocity, Real speed);

/// |v - Pv|^2, P the projection onto the cone 0 <= w_1 <= ... <= w_N, by pooling adjacent violators (isotonic
/// regression) in one pass. Why the cone: every completed contact hands momentum upwards (int F dt = K int x dt >= 0, as
/// x starts and ends at 0), and at the end nothing approaches. So the final velocities lie in the cone, and differ from
/// today's by an element of its polar cone; by Moreau's decomposition their norm is at least |Pv|.
template <class Real>
Real distance_to_separated(std::span<const Real> velocity);

/// Largest amount by which eps_eff can still fall when all contacts are open and the beads have these velocities.
template <class Real>
Real residual_dissipation(std::span<const Real> velocity, Real speed);

}  // namespace sigmasweep
