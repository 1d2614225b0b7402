#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// A collision as a film: where the beads are, and how fast, at given times.
namespace sigmasweep {

/// Beads are numbered from 0, the lowest, here. Values of sample s and bead i are at [s * beads() + i].
struct Trajectory {
  /// s, ascending; 0 is the start: all gaps as given, all beads at -v0, or at rest relative to the plate.
  std::vector<double> time;
  /// Of a column reduced heights, Eq. (9), m: the sum of the gaps below a bead, overlaps negative, and of the plate's
  /// height. Of a lattice the heights of the centres above the bottom (a plate's middle position), m.
  std::vector<double> z;
  std::vector<double> velocity;  ///< upwards, m/s; just before the collision where hard spheres meet at that time
  std::vector<double> mass;      ///< of the beads, over the mean bead's
  std::vector<double> diameter;  ///< of the beads, m
  /// Of a lattice, else empty: horizontal positions from the container's left end, m, and velocities, m/s. Where it is
  /// periodic they go on beyond its ends: beads that leave it are the images of those that come in.
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

/// The collision of simulate(parameters), seen at `times` (s, ascending, from the start). The solver is the same, but
/// goes on to the last of the times where simulate() stops once nothing of interest can happen, and its numbers are
/// doubles, without an error bar. The exact solver and hard spheres are exact to rounding (chaotic columns as far as
/// doubles carry), that of lattices to a local error of 1e-12; between steps of a fixed-step scheme there is cubic
/// interpolation for z, linear for the velocity. NaN from where the solver gave up.
Trajectory record(const Parameters& parameters, std::span<const double> times);

/// 1.5 times from the start to the last contact with the wall that `collision`, the result of simulate(), reports: long
/// enough to see what comes of it. For hard spheres that start in touch, all of whose collisions are at time zero, 1.5
/// times N tc, the duration of the soft column's contact. Of lattices not longer than 3 rows (tc + (s0 + width)/v0)
/// after the first contact, in which the lattice closes and opens again: single beads come back to the wall much later.
/// What vibrates: ten periods. s; NaN where there is no result.
double show_time(const Parameters& parameters, const SimulationResult& collision);

/// `count` >= 2 times from 0 to `duration`, both included, evenly spaced.
std::vector<double> sample_times(double duration, std::size_t count);

}  // namespace sigmasweep
