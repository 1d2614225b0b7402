#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assembly/column.hpp"
#include "base/vec2.hpp"
#include "sigmasweep/model/parameters.hpp"

/// Two dimensions: a triangular lattice of discs that flies at a wall (Sec. IV C), or lies on a plate that vibrates
/// (Sec. II A).
namespace sigmasweep {

/// rows x columns beads on a triangular lattice, in a column's units; bead i is in row i / columns, counted from below,
/// and every other row is half a lattice constant to the right. Bead masses and the contact laws of pairs and of walls
/// (all walls are alike) are those of a column. While two beads touch they also rub, Eq. (4): with v_t the tangential
/// part of their relative velocity the force is -D_t m_ij v_t, m_ij = 2 m_i m_j/(m_i + m_j) as in Eq. (3), which for
/// equal beads is the m_i of the paper; at a wall -D_t m_i v_t.
template <class Real>
struct Lattice {
  Column<Real> beads;  ///< N, gap, speed, tc, laws and masses; its gaps are not used
  std::int64_t rows = 1, columns = 1;
  Real d{};        ///< mean diameter
  Real largest{};  ///< the largest diameter that `width` allows
  Real a{};        ///< lattice constant: largest + gap
  Real D_t{};
  bool periodic = true;           ///< to the left and right; else there are walls
  std::vector<Vec2<Real>> shift;  ///< of the beads from their sites at the start; empty: none

  std::size_t count() const { return static_cast<std::size_t>(rows * columns); }
  /// Of the container: columns a, or with side walls what leaves a gap to the outermost beads of either kind of row.
  Real width() const;
  Real diameter(std::size_t i) const;
  Real mass(std::size_t i) const { return beads.is_uniform() ? Real(1) : beads.mass[i]; }
  /// A collision is over when nothing has touched for 2 N s0/v0 (Sec. IV C); of beads that differ in size, whose gaps
  /// do, too, with s0 + width for s0. 0 where neither is: then it is over when nothing approaches.
  Real quiet_time() const;
  /// What rounding leaves open of positions after the longest flight of the fall, in units of speed times tc.
  Real rounding() const;
  /// Where the lattice has bead i, from the container's lower left corner. The lowest row is a gap above the bottom.
  Vec2<Real> site(std::size_t i) const;
};

/// In reduced units: time in tc, length in v0 tc. Random diameters and shifts come from the seed alone.
template <class Real>
Lattice<Real> reduced_lattice(const Parameters& parameters);

/// Shifts every bead by up to half a gap to either side, horizontally and vertically, in the order of their numbers;
/// drawn again while it overlaps one that has its place already. Values 0, 1, ... of random_bits(key, .).
template <class Real>
void shift_at_random(Lattice<Real>& lattice, std::uint64_t key);

/// eps_eff and so on of final velocities; E_r is relative to the velocity of the centre of mass, v_cm its vertical
/// part.
template <class Real>
Energies<Real> energies(const Lattice<Real>& lattice, const std::vector<Vec2<Real>>& velocity);

}  // namespace sigmasweep
