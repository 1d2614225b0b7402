#pragma once

#include <string_view>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "studies/precision/study.hpp"

/// Measurements of a precision study: errors and times of all integrators. Errors are differences from references that
/// are exact to many more digits.
namespace sigmasweep {

/// Measures all settings of one scene, in the order of the spec.
///
/// The tuples of a scene differ slightly, so that contacts occur at random phases of a step; contacts in phase with the
/// steps would make errors look too small. In collisions sigma varies by up to 1e-3, and with fixed steps the start is
/// higher by a random fraction of a step's flight. Lattices have different shifts. On a plate the amplitude varies by
/// up to 1e-3, and steps are up to 1 % shorter. The tuples are the same for all integrators.
///
/// Errors are given for eps_eff and the final velocities, on a plate for h_cm/A0 only. A solver stops when later
/// contacts cannot change eps_eff by more than 1e-3 of the tolerance (1e-13 for fixed steps), so that the error of its
/// velocities is of the order of the square root of this number.
///
/// There is one reference for all tuples and a second one for the first `checks` (cases/). For equal beads and the
/// linear law these are Taylor series in long double, and normal modes, which share no code; on a plate Taylor series
/// and an event-located scheme of order 8. All others use one method twice, which is less independent: Taylor series in
/// long double and in quadruple precision for unequal beads of columns, event-located schemes with different local
/// errors, 1e-17 to 1e-13, for other laws and lattices. A tuple is chaotic if its references differ by more than 1e-9.
/// It is not compared, and in a scene with chaotic tuples only tuples with both references are.
///
/// Times are CPU times of the calling thread. They include the error bar for `exact` without a plate, and do not
/// include the reference solution that a sweep adds for the error bar of fixed steps.
std::vector<PrecisionRow> measure_precision(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec);

/// The quantity whose error is measured: "eps_eff", on a plate "h_cm/A0".
std::string_view precision_quantity(const Parameters& parameters);

/// Predicted CPU time of measure(), s.
double predicted_precision_time(const Parameters& scene, const PrecisionSpec& spec);

}  // namespace sigmasweep
