#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "sigmasweep/model/trajectory.hpp"

/// A run of a solver as a film: where the beads are, and how fast, at given times.
namespace sigmasweep {

/// The run of simulate(parameters), seen at `times` (s, ascending, from the start). The solver is the same, but goes on
/// to the last of the times where simulate() stops once nothing of interest can happen, and its numbers are doubles,
/// without an error bar. The exact solver and hard spheres are exact to rounding (chaotic columns as far as doubles
/// carry), that of lattices to a local error of 1e-12. Between steps of a fixed-step scheme positions are interpolated
/// by a cubic, velocities by a straight line. NaN from where the solver gave up.
Trajectory record(const Parameters& parameters, std::span<const double> times);

/// Duration of a film that shows the run, s; NaN where there is no result. `collision`: the result of simulate().
/// - Collisions of soft spheres: 1.5 times the time from the start to the last contact with the wall.
/// - Hard spheres that start in touch collide at time zero only: 1.5 N tc, after the duration of the soft column's
///   contact.
/// - Lattices: not longer than 3 rows (tc + (s0 + width)/v0) after the first contact. The lattice closes and opens
/// again
///   within that time; single beads come back to the wall much later.
/// - Vibrated beads: ten periods of the plate.
double show_time(const Parameters& parameters, const SimulationResult& collision);

/// `count` >= 2 times from 0 to `duration`, both included, evenly spaced.
std::vector<double> sample_times(double duration, std::size_t count);

}  // namespace sigmasweep
