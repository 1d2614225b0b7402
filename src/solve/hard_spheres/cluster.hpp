#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace sigmasweep {

/// A set of touching beads that would move on together if their collisions were perfectly inelastic.
struct Cluster {
  std::size_t first = 0;  ///< its lowest bead, 0 being the one (or the wall) below the lowest contact of the run
  std::size_t beads = 1;  ///< how many, a wall counted as one
  bool wall = false;
  double bottom_change = 0.0, top_change = 0.0;  ///< of the velocities of its lowest and highest bead
  double fastest = 0.0;                          ///< largest closing speed
  double least_impulse = 0.0;                    ///< smallest momentum still to be handed through a contact
  double parting = 0.0;                          ///< speed at which the nearest touching bead outside leaves
};

/// The cluster around contact k of a run of touching contacts with closing speeds u, the first of them at the wall if
/// `on_wall`, none of them faster than u[k] > 0. It gets its common velocity when all velocities go to those without
/// approach that are closest to them (Moreau's plastic impact), found by pooling adjacent violators. `mass` has the
/// run's beads from the one below the first contact on (the wall's is not looked at); empty where all are 1.
Cluster cluster_around(std::size_t k, std::span<const double> u, bool on_wall, std::span<const double> mass = {});

/// Whether infinitely many collisions in no time will make the cluster of equal beads one, seen long before its speeds
/// have vanished: when all closing speeds are below a quarter of the momenta still to be handed on, and the cluster is
/// by a quarter more dissipative than the threshold of collapse,
///     1 - eps = 1 - tan^2(pi/4 (1 - 1/n))
/// for n beads on a wall (B. Bernu & R. Mazighi, J. Phys. A 23, 5745 (1990)), or 2n free ones. Why, and how far it was
/// checked: docs/physics/hard-spheres.md.
bool will_collapse(const Cluster& cluster, double eps);

}  // namespace sigmasweep
