#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "sigmasweep/model/trajectory.hpp"

/// The trajectory of a tuple: positions and velocities of all beads at given times.
namespace sigmasweep {

/// The trajectory of simulate(parameters) at `times`, s, ascending, from the start. It is computed by the same solver
/// in double precision, without an error bar, up to the last time. The exact solver of columns and that of hard
/// spheres are exact to rounding, except for chaotic columns; the exact solver of lattices has a local error of 1e-12.
/// Between fixed steps positions are interpolated by a cubic, velocities linearly. Samples are NaN after the solver
/// gave up.
Trajectory record(const Parameters& parameters, std::span<const double> times);

/// Duration of a trajectory that shows the whole run, s; NaN without a result. `collision` is the result of simulate().
/// - Soft spheres: 1.5 times the time from the start to the last contact with the wall.
/// - Hard spheres that start in touch: 1.5 N tc, about the duration of the soft column's contact, because their
///   collisions take no time.
/// - Lattices: at most 3 rows (tc + (s0 + width)/v0) after the first contact. The lattice closes and opens within this
///   time; single beads return to the wall much later.
/// - A plate: ten periods.
double show_time(const Parameters& parameters, const SimulationResult& collision);

/// `count` >= 2 evenly spaced times from 0 to `duration`, both included.
std::vector<double> sample_times(double duration, std::size_t count);

}  // namespace sigmasweep
