#pragma once

#include <span>

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/trajectory.hpp"
#include "solve/observer/samples.hpp"

/// Recording of columns: a solver shows overlaps and rates in its own units, from when its clock starts on; the
/// trajectory has heights and velocities of beads in SI. One function for each convention of units and clock.
namespace sigmasweep {

using ObserveColumn = void (*)(const Parameters&, const Column<double>&, Samples&);
using ObserveVibrated = void (*)(const Parameters&, VibratedSamples&);

/// Units tc and v0 tc; the clock starts with the fall.
Trajectory record_from_start(const Parameters& parameters, std::span<const double> times, ObserveColumn observe);
/// Units tc and v0 tc; the clock starts at the first contact with the wall.
Trajectory record_from_first_contact(const Parameters& parameters, std::span<const double> times,
                                     ObserveColumn observe);
/// Hard spheres: units s0/v0 and s0, without a gap tc and v0 tc; the clock starts with the fall.
Trajectory record_in_gaps(const Parameters& parameters, std::span<const double> times, ObserveColumn observe);
/// Columns on a plate: vibration_units(), overlaps and rates relative to the plate.
Trajectory record_on_plate(const Parameters& parameters, std::span<const double> times, ObserveVibrated observe);

}  // namespace sigmasweep
