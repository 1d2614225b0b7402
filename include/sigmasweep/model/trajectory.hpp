#pragma once

#include <cstddef>
#include <vector>

namespace sigmasweep {

/// Recorded motion of all beads. Beads are numbered from 0, the lowest. Values of sample s and bead i are at
/// [s * beads() + i].
struct Trajectory {
  /// Times of the samples, s, ascending. At 0, the start, all gaps are as given, and all beads move at -v0, or are at
  /// rest relative to the plate.
  std::vector<double> time;
  /// Of a column reduced heights, Eq. (9), m: the plate's height plus the sum of the gaps below a bead, overlaps
  /// counted as negative. Of a lattice the heights of the centres above the bottom (a plate's middle position), m.
  std::vector<double> z;
  std::vector<double> velocity;  ///< upwards, m/s; just before the collision where hard spheres meet at that time
  std::vector<double> mass;      ///< of the beads, over the mean bead's
  std::vector<double> diameter;  ///< of the beads, m
  /// Of a lattice, else empty: horizontal positions from the container's left end, m, and velocities, m/s. Where the
  /// container is periodic they go on beyond its ends: beads that leave it are the images of those that come in.
  std::vector<double> x{}, x_velocity{};
  double box_width = 0.0;  ///< of a lattice's container, m
  bool periodic = false;   ///< to the left and right; else there are walls

  bool is_plane() const { return !x.empty(); }
  std::size_t beads() const { return mass.size(); }
  std::size_t samples() const { return time.size(); }
  /// The height of bead i's centre at rest in the closed column, all beads touching: h_i = z_i + base(i). 0 in two
  /// dimensions.
  double base(std::size_t bead) const;
};

}  // namespace sigmasweep
