#pragma once

#include <string_view>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "studies/precision/study.hpp"

/// The precision study: error of every integrator against its time, measured against references that are better by
/// many digits.
namespace sigmasweep {

/// All settings of one scene, in the order of the spec.
///
/// The tuples of a scene are alike, but contacts fall anywhere within a step: contacts in phase with the grid would
/// make errors look smaller than they are. Tuples that fly have other values of sigma (by up to 1e-3) and, in fixed
/// steps, begins higher by a random fraction of a step's flight; lattices have other shifts; what vibrates has another
/// amplitude (by up to 1e-3), and steps shorter by up to 1 %. They are the same for all integrators.
///
/// Errors are those of eps_eff and of the final velocities; of what vibrates of h_cm/A0, no velocities. Velocities are
/// those that a solver leaves: it stops once later contacts cannot change eps_eff by more than 1e-3 of the tolerance
/// (1e-13 for fixed steps), which leaves the square root of that in velocities open.
///
/// References (cases/): one for all tuples, and another for the first `checks`. Equal
/// beads and the linear law: Taylor series in long double, and normal modes, which share no code with these; on a plate
/// Taylor series and an event-located scheme of order 8. All others have one method twice, which is less independent:
/// unequal beads of columns Taylor series in long double and in quadruple precision, other laws and lattices
/// event-located schemes with different local errors, 1e-17 to 1e-13. Where the two differ by more than 1e-9 the
/// outcome is chaotic: such tuples are not compared, and in scenes that have any only tuples with both references are.
///
/// Times are CPU times of the calling thread: with an error bar for `exact`, of what vibrates without; for fixed steps
/// without the reference solution that a sweep adds for its error bar.
std::vector<PrecisionRow> measure_precision(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec);

/// What the errors are of: "eps_eff", or of what vibrates "h_cm/A0".
std::string_view precision_quantity(const Parameters& parameters);

/// Predicted CPU time of that, s.
double predicted_precision_time(const Parameters& scene, const PrecisionSpec& spec);

}  // namespace sigmasweep
