#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "assembly/lattice.hpp"
#include "base/vec2.hpp"
#include "numerics/hermite.hpp"

namespace sigmasweep {

/// Displacement from the site, velocity and acceleration of a bead.
template <class Real>
struct BeadState {
  Vec2<Real> q, v, a;
};

/// From a partner j to bead i: another bead, one of its images, or a wall. The distance is that of their sites changed
/// by their displacements, q = q_i - q_j, so that a gap keeps its digits however small it is beside a diameter:
///     |R + q| - |R| = (2 R.q + q.q)/(|R + q| + |R|),  and |R| - d_ij is the lattice's gap for neighbouring sites.
template <class Real>
struct Bond {
  Vec2<Real> R;   ///< from site j to site i; from a wall: its unit normal
  Real length{};  ///< |R|; 0: a wall
  Real gap0{};    ///< gap where q = 0

  /// The gap, and the unit vector from the partner to the bead.
  struct GapAndNormal {
    Real gap;
    Vec2<Real> n;
  };
  GapAndNormal gap_and_normal(const Vec2<Real>& q) const {
    using std::sqrt;
    if (length == Real(0)) return {gap0 + dot(R, q), R};
    const Vec2<Real> r = R + q;
    const Real distance = sqrt(dot(r, r)), sum = distance + length, inverse = 1 / (distance * sum);
    return {gap0 + (2 * dot(R, q) + dot(q, q)) * (distance * inverse), (sum * inverse) * r};
  }
  /// The gap with its rate u = n.w and second derivative n.w' + (w.w - u^2)/|r|, of the motion relative to the partner.
  Motion<Real> gap_of(const BeadState<Real>& relative) const {
    const auto [n, distance] = direction(relative.q);
    const Real u = dot(n, relative.v);
    return {gap(relative.q), u, dot(n, relative.a) + (dot(relative.v, relative.v) - u * u) / distance};
  }
  Real gap(const Vec2<Real>& q) const {
    using std::sqrt;
    if (length == Real(0)) return gap0 + dot(R, q);
    const Vec2<Real> r = R + q;
    return gap0 + (2 * dot(R, q) + dot(q, q)) / (sqrt(dot(r, r)) + length);
  }
  /// Unit vector from the partner to the bead, and the distance between their centres (of a wall infinite).
  struct Direction {
    Vec2<Real> n;
    Real distance;
  };
  Direction direction(const Vec2<Real>& q) const {
    using std::sqrt;
    if (length == Real(0)) return {R, std::numeric_limits<Real>::infinity()};
    const Vec2<Real> r = R + q;
    const Real distance = sqrt(dot(r, r));
    return {(1 / distance) * r, distance};
  }
};

/// A neighbour of a bead: another bead or a wall.
template <class Real>
struct Neighbour {
  static constexpr std::uint32_t bottom = UINT32_MAX, left = UINT32_MAX - 1, right = UINT32_MAX - 2;
  std::uint32_t bead = 0;  ///< number of the bead, or of a wall
  std::int32_t image = 0;  ///< number of containers by which this image is to the right of the bead
  Bond<Real> bond;
  bool is_wall() const { return bead >= right; }
  bool is(std::uint32_t other, std::int32_t its_image) const { return bead == other && image == its_image; }
  /// Bead `me` as a neighbour of this one.
  Neighbour seen_from_there(std::uint32_t me) const { return {me, -image, {-bond.R, bond.length, bond.gap0}}; }
};

/// Neighbour lists of all beads. A list is valid while the bead stays within `leeway()` of its place when the list was
/// made; see move(). Lists are mutual. Memory is linear in the number of beads.
template <class Real>
class LatticeNeighbours {
 public:
  /// Lists of the lattice's sites with its shifts.
  explicit LatticeNeighbours(const Lattice<Real>& lattice);

  const std::vector<Neighbour<Real>>& of(std::size_t i) const { return lists_[i]; }
  /// Largest distance of a bead from anchor(i) before its list must be made again.
  const Real& leeway() const { return leeway_; }
  /// The displacement of bead i from its site at which its list was made.
  const Vec2<Real>& anchor(std::size_t i) const { return anchor_[i]; }
  /// Makes the list of bead i again, now with displacement q, and changes the lists of its neighbours. Returns the new
  /// bonds of bead i, which are valid until the next call.
  const std::vector<Neighbour<Real>>& move(std::size_t i, const Vec2<Real>& q);

 private:
  using Cell = std::int64_t;

  Vec2<Real> position(std::size_t i) const { return site_[i] + anchor_[i]; }
  Cell cell(std::int64_t column, std::int64_t row) const;
  void enter(std::size_t i);
  void leave(std::size_t i);
  void forget(std::size_t i);
  std::vector<Neighbour<Real>> find(std::size_t i) const;
  void add_images(std::size_t i, std::size_t j, std::vector<Neighbour<Real>>& found) const;
  void add_walls(std::size_t i, std::vector<Neighbour<Real>>& found) const;
  Bond<Real> bond(std::size_t i, std::size_t j, std::int32_t image) const;

  const Lattice<Real>& lattice_;
  Real width_;
  Real reach_;  ///< distance of centres up to which beads are on each other's lists
  Real leeway_;
  std::int64_t columns_;  ///< of cells of at least the reach, in the container's width
  std::vector<Vec2<Real>> site_, anchor_;
  std::vector<Cell> cell_of_;
  std::unordered_map<Cell, std::vector<std::uint32_t>> cells_;
  std::vector<std::vector<Neighbour<Real>>> lists_;
  std::vector<Neighbour<Real>> fresh_;
};

}  // namespace sigmasweep
