#pragma once

#include <span>

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/trajectory.hpp"
#include "solve/observer/samples.hpp"

/// Recording of columns. Solvers give overlaps and rates in reduced units and from their own origin of time; the
/// trajectory has heights and velocities of beads in SI. There is a function for each choice of units and origin.
namespace sigmasweep {

using ObserveColumn = void (*)(const Parameters&, const Column<double>&, Samples&);
using ObserveVibrated = void (*)(const Parameters&, VibratedSamples&);

/// Units tc and v0 tc; time counts from the start of the fall.
Trajectory record_from_start(const Parameters& parameters, std::span<const double> times, ObserveColumn observe);
/// Units tc and v0 tc; time counts from the first contact with the wall.
Trajectory record_from_first_contact(const Parameters& parameters, std::span<const double> times,
                                     ObserveColumn observe);
/// Hard spheres: units s0/v0 and s0, for s0 = 0 tc and v0 tc; time counts from the start of the fall.
Trajectory record_in_gaps(const Parameters& parameters, std::span<const double> times, ObserveColumn observe);
/// Columns on a plate: units vibration_units(); overlaps and rates are relative to the plate.
Trajectory record_on_plate(const Parameters& parameters, std::span<const double> times, ObserveVibrated observe);

}  // namespace sigmasweep
