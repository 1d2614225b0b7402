#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace sigmasweep {

/// A cluster of touching beads that would move on together if their collisions were perfectly inelastic.
struct Cluster {
  std::size_t first = 0;  ///< lowest bead; 0 is the bead (or wall) below the lowest contact of the run
  std::size_t beads = 1;  ///< number of beads; a wall counts as one
  bool wall = false;
  double bottom_change = 0.0, top_change = 0.0;  ///< changes of velocity of the lowest and the highest bead
  double fastest = 0.0;                          ///< largest closing speed
  double least_impulse = 0.0;                    ///< smallest momentum that a contact has still to transfer
  double parting = 0.0;                          ///< speed at which the nearest touching bead outside moves away
};

/// The cluster around contact k of a run of touching contacts with closing speeds u. u[k] > 0 is the largest of them;
/// with `on_wall` the first contact is that with the wall. In Moreau's plastic impact the velocities become the closest
/// ones without approach, which are found by pooling adjacent violators; the cluster is the beads that share the
/// velocity of contact k. `mass` is that of the run's beads from the one below the first contact on; the wall's is not
/// used. Empty: all masses are 1.
Cluster cluster_around(std::size_t k, std::span<const double> u, bool on_wall, std::span<const double> mass = {});

/// Whether the cluster of equal beads will collapse, which is decided long before its closing speeds vanish: all
/// closing speeds are below a quarter of the momenta still to be transferred, and the dissipation is by a quarter above
/// the threshold of collapse,
///     1 - eps = 1 - tan^2(pi/4 (1 - 1/n))
/// for n beads on a wall (B. Bernu & R. Mazighi, J. Phys. A 23, 5745 (1990)), or 2n free ones. See
/// docs/physics/hard-spheres.md.
bool will_collapse(const Cluster& cluster, double eps);

}  // namespace sigmasweep
