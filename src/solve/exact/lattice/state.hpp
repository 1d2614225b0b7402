#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "assembly/neighbours.hpp"
#include "solve/exact/lattice/cluster.hpp"

namespace sigmasweep {

/// Motions of all beads of a lattice as far as they are known: a bead in no contact flies in closed form, beads that
/// touch are moved by clusters, each with a clock of its own. Also which beads touch, and the lists of neighbours.
template <class Real, class Ground>
struct LatticeState {
  using Cluster = LatticeCluster<Real, Ground>;
  static constexpr Real never = std::numeric_limits<Real>::infinity();

  struct Bead {
    Vec2<Real> q, v;  ///< in no contact: at time `since`
    Real since{};
    std::int32_t cluster = -1;
    std::uint32_t place = 0;  ///< in its cluster
    std::uint32_t version = 0;
  };
  struct Held {
    std::unique_ptr<Cluster> cluster;
    std::uint32_t version = 0;
    std::uint64_t counted = 0;           ///< of its work, before it was taken into use
    bool in_use = false, whole = false;  ///< whole: has no guests and is small
  };

  LatticeState(const Lattice<Real>& lattice_, const Ground& ground_);

  BeadState<Real> at(std::size_t i, const Real& t) const;
  /// How far ahead the bead's motion is known.
  Real until(std::size_t i) const;
  /// The gap between a bead and its neighbour, its rate and second derivative.
  Motion<Real> gap(std::size_t i, const Neighbour<Real>& other, const Real& t) const;
  bool touches(std::size_t i, const Neighbour<Real>& other) const;
  Cluster& cluster(std::size_t id) const { return *clusters[id].cluster; }
  /// Beads that are marked take part in the present event.
  bool is_marked(std::size_t i) const { return mark[i] == marks; }

  const Lattice<Real>& lattice;
  [[no_unique_address]] Ground ground;
  LatticeNeighbours<Real> neighbours;
  std::vector<Bead> beads;
  std::vector<std::vector<Neighbour<Real>>> touching;
  std::vector<Held> clusters;
  std::vector<std::uint32_t> mark;  ///< of each bead: the event that it was marked in last
  std::uint32_t marks = 0;          ///< number of the present event
};

}  // namespace sigmasweep
