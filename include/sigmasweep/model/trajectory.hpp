#pragma once

#include <cstddef>
#include <vector>

namespace sigmasweep {

/// Recorded motion of all beads. Beads are numbered from 0, the lowest one. Values of sample s and bead i are at
/// [s * beads() + i].
struct Trajectory {
  /// Times of the samples, s, ascending. At time 0 all gaps are as given, and all beads move at -v0, or are at rest
  /// relative to the plate.
  std::vector<double> time;
  /// Column: reduced heights, Eq. (9), m, the plate's height plus the sum of the gaps below a bead, with overlaps as
  /// negative gaps. Lattice: heights of the centres above the bottom, or above the middle position of the plate, m.
  std::vector<double> z;
  std::vector<double> velocity;  ///< upwards, m/s; just before the collision if hard spheres collide at this time
  std::vector<double> mass;      ///< of each bead, in masses of the mean bead
  std::vector<double> diameter;  ///< of each bead, m
  /// Lattice (else empty): horizontal positions from the container's left end, m, and velocities, m/s. In a periodic
  /// container positions continue beyond its ends.
  std::vector<double> x{}, x_velocity{};
  double box_width = 0.0;  ///< width of a lattice's container, m
  bool periodic = false;   ///< the container has no side walls

  bool is_plane() const { return !x.empty(); }
  std::size_t beads() const { return mass.size(); }
  std::size_t samples() const { return time.size(); }
  /// The height of bead i's centre in the closed column at rest, m, so that h_i = z_i + base(i). 0 in two dimensions.
  double base(std::size_t bead) const;
};

}  // namespace sigmasweep
