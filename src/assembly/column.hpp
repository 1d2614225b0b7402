#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// The problem that the solvers solve, in any consistent system of units with bead mass 1.
namespace sigmasweep {

/// A column of N beads that flies into the wall at `speed`. Contact k is that of beads k and k+1, contact 0 that of the
/// wall and bead 1. While it is closed its force is F_k = K_k x_k^(1+beta) + C_k x_k^gamma x_k', with the overlap x_k >
/// 0; Eqs. (2), (3), (8). Real is double, long double or a wider type.
template <class Real>
struct Column {
  std::int64_t N = 1;
  Real gap{};               ///< s0
  Real speed{};             ///< v0
  Real tc{};                ///< pair contact time, Eq. (6) or (A2)
  Real eps{};               ///< pair restitution, Eq. (7)
  Real eps_wall{};          ///< wall restitution, for hard spheres
  Real K{}, C{};            ///< pair of mean beads: spring K/m and dashpot D_n, both over the mean bead's mass
  Real K_wall{}, C_wall{};  ///< spring and dashpot of the wall and the mean bead
  Exponents exponents{};    ///< beta, gamma; the linear law has 0, 0
  std::vector<Real> mass;   ///< masses of beads 1..N over the mean bead's; empty if all are equal
  std::vector<Real> gaps;   ///< initial gap of each contact; empty if all are `gap`

  bool is_uniform() const { return mass.empty(); }
  std::size_t contacts() const { return static_cast<std::size_t>(N); }
  /// Spring of contact k.
  Real spring(std::size_t k) const { return k == 0 ? K_wall : K; }
  /// Dashpot of contact k: D_n m_ij, m_ij = 2 m_i m_j/(m_i + m_j), Eq. (3); at the wall D_n times the bead's mass.
  Real dashpot(std::size_t k) const {
    if (mass.empty()) return k == 0 ? C_wall : C;
    return k == 0 ? Real(C_wall * mass[0]) : Real(C * 2 * mass[k - 1] * mass[k] / (mass[k - 1] + mass[k]));
  }
  Real initial_gap(std::size_t k) const { return gaps.empty() ? gap : gaps[k]; }
  /// 1/m of bead i, counted from 0.
  Real inverse_mass(std::size_t i) const { return mass.empty() ? Real(1) : Real(1 / mass[i]); }
  /// One over the reduced mass of contact k, by which its force F changes its own overlap: x'' = -inertia F + ...
  Real inertia(std::size_t k) const { return k == 0 ? inverse_mass(0) : Real(inverse_mass(k - 1) + inverse_mass(k)); }
};

/// The column in reduced units: time in tc, length in v0 tc. Its parameters are sigma, N and epsilon, and for nonlinear
/// laws the exponents. Random diameters and separations depend on the seed alone.
template <class Real>
Column<Real> reduced_column(const Parameters& parameters);

/// The same column in raw SI units: the check that the reduction is right.
template <class Real>
Column<Real> si_column(const Parameters& parameters);

}  // namespace sigmasweep
