#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energies.hpp"
#include "base/vec2.hpp"
#include "sigmasweep/model/parameters.hpp"

/// Problems in two dimensions: a triangular lattice of discs that flies into a wall (Sec. IV C), or lies on a plate
/// that vibrates (Sec. II A).
namespace sigmasweep {

/// A triangular lattice of rows x columns beads, in a column's units. Bead i is in row i / columns, counted from below;
/// every other row is half a lattice constant to the right. Masses and contact laws of pairs and walls are those of a
/// column; all walls are alike. Two beads in contact also have the tangential force -D_t m_ij v_t, Eq. (4), with the
/// tangential part v_t of their relative velocity and m_ij = 2 m_i m_j/(m_i + m_j) as in Eq. (3), which is the paper's
/// m_i for equal beads. At a wall it is -D_t m_i v_t.
template <class Real>
struct Lattice {
  Column<Real> beads;  ///< N, gap, speed, tc, laws and masses; Column::gaps is not used
  std::int64_t rows = 1, columns = 1;
  Real d{};        ///< mean diameter
  Real largest{};  ///< the largest diameter that `width` allows
  Real a{};        ///< lattice constant: largest + gap
  Real D_t{};
  bool periodic = true;           ///< to the left and right; else there are side walls
  std::vector<Vec2<Real>> shift;  ///< initial displacements of the beads from their sites; empty: none

  std::size_t count() const { return static_cast<std::size_t>(rows * columns); }
  /// Width of the container: columns a, or with side walls the width with a gap to the outermost beads of all rows.
  Real width() const;
  Real diameter(std::size_t i) const;
  Real mass(std::size_t i) const { return beads.is_uniform() ? Real(1) : beads.mass[i]; }
  /// Time without a contact after which a collision is over: 2 N s0/v0 (Sec. IV C), for unequal beads with s0 + width
  /// instead of s0. If it is 0, the collision is over when no beads approach.
  Real quiet_time() const;
  /// Rounding error of positions after the longest flight of the fall, in units of speed times tc.
  Real rounding() const;
  /// The site of bead i, from the container's lower left corner. The lowest row is a gap above the bottom.
  Vec2<Real> site(std::size_t i) const;
};

/// The lattice in reduced units: time in tc, length in v0 tc. Random diameters and shifts depend on the seed alone.
template <class Real>
Lattice<Real> reduced_lattice(const Parameters& parameters);

/// Shifts each bead by up to half a gap to either side, horizontally and vertically, in the order of their numbers. A
/// shift is drawn again while the bead overlaps an earlier one. The random numbers are random_bits(key, 0), (key, 1),
/// ...
template <class Real>
void shift_at_random(Lattice<Real>& lattice, std::uint64_t key);

/// Energy ratios of final velocities. E_r is relative to the velocity of the centre of mass, whose vertical part is
/// v_cm.
template <class Real>
Energies<Real> energies(const Lattice<Real>& lattice, const std::vector<Vec2<Real>>& velocity);

}  // namespace sigmasweep
