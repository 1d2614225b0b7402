#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "assembly/column.hpp"
#include "base/vec2.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

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

/// The longest times without a contact, the longest first; one may be the one after the end.
template <class Real>
struct Waits {
  struct Wait {
    Real length{}, change{};  ///< about what eps_eff would differ by if it had been on the other side of quiet_time()
  };
  std::array<Wait, 6> longest{};

  void note(const Wait& wait) {
    auto place = std::ranges::find_if(longest, [&](const Wait& w) { return w.length < wait.length; });
    if (place == longest.end()) return;
    std::move_backward(place, longest.end() - 1, longest.end());
    *place = wait;
  }
};

/// What a solver hands back, in the lattice's units.
template <class Real>
struct LatticeOutcome {
  std::vector<Vec2<Real>> velocity;
  Real t_k{};                  ///< from the first to the last contact with the bottom
  Real x_max{};                ///< largest overlap
  Real remainder{};            ///< End::settled: estimate of what later contacts can still change eps_eff by
  Waits<Real> waits;           ///< End::quiet, from event to event
  std::uint64_t contacts = 0;  ///< contacts closed and opened again
  Real contact_time{};  ///< how long they were closed, all together; from event to event only, until the last one
  End end = End::none;
  Status status = Status::ok;
};

/// eps_eff and so on of final velocities; E_r is relative to the velocity of the centre of mass, v_cm its vertical
/// part.
template <class Real>
Energies<Real> energies(const Lattice<Real>& lattice, const std::vector<Vec2<Real>>& velocity);

struct LatticeOptions {
  double accuracy = 1e-12;  ///< local error of a step, in units of the speed and of speed times tc
  double settle = 1e-13;    ///< stop once what approaches (without a gap) or creeps can hardly change eps_eff by more
  std::uint64_t event_limit = 0;  ///< contacts before giving up; 0: 100,000 + 1,000 N
  /// Beads and contacts moved in stages of steps; 0: 1e10 + 2e7 N, some minutes. With fixed steps beads times steps;
  /// 1e10.
  std::uint64_t work_limit = 0;
  ComputeBudget* budget = nullptr;
};

/// The default integrator: beads in no contact fly, clusters of beads that touch are moved by DOP853 each on its own,
/// and every contact's closing and opening is located. Nothing costs time but contacts.
/// End::quiet where quiet_time() > 0. Else separated, when nothing touches and none of those within 0.6 d of each other
/// or of a wall approach (what drifts sideways to a wall further away does not count), or settled, when these can lose
/// next to nothing; that is also the end of overdamped beads that creep. Real: double or long double.
template <class Real>
LatticeOutcome<Real> lattice_collision(const Lattice<Real>& lattice, const LatticeOptions& options = {});

/// The tuple's collision with an error bar.
SimulationResult simulate_lattice(const Parameters& parameters, ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
