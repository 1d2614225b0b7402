#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace sigmasweep {

/// Touching beads that would move on together if touching beads were perfectly inelastic.
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
/// have vanished. A collision between contacts k takes (1+eps)/2 u_k off the momentum p_k that contact k has still to
/// hand on, and leaves every other p alone; u_k = 2 p_k - p_(k-1) - p_(k+1). The cluster collapses unless some p_k
/// falls below zero, which the next collision can only do if u_k > 2 p_k/(1+eps). So the answer is yes when
/// - all closing speeds are below a quarter of every p_k, so that no wave runs any more, only diffusion, and
/// - the column is more dissipative than the threshold of collapse, 1 - eps = 1 - tan^2(pi/4 (1 - 1/n)) for n beads on
///   a wall (B. Bernu & R. Mazighi, J. Phys. A 23, 5745 (1990)), or 2n free ones, by a quarter, so that it stays so.
/// Not a theorem: runs down to vanishing speeds agree in all of 3040 cases (N = 4..48, N(1-eps) = 0.5..9, both walls),
/// and still do with one half in place of the first quarter. For unequal masses there is no such rule: with the
/// threshold from their own matrix it was wrong for 1 of 100 columns.
bool will_collapse(const Cluster& cluster, double eps);

}  // namespace sigmasweep
