#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/sweep/precision.hpp"
#include "sigmasweep/sweep/row.hpp"

/// The precision study: error of every integrator against its time, measured against references that are better by
/// many digits.
namespace sigmasweep {

/// All settings of one scene, in the order of the spec.
///
/// A tuple is the scene with sigma changed at random by up to 1e-3 of itself, the same for all integrators. For those
/// of fixed step the wall is also further away by a random fraction of a step's flight, so that its contact, and what
/// follows, falls anywhere within a step: that changes nothing else, and contacts in phase with the grid would make the
/// error look smaller than it is.
///
/// References, equal beads and the linear law: Taylor series in long double for all tuples, and normal modes, which
/// share no code with these, for the first `checks`. Other laws: nonlinear_collision<long double> at 1e-17, and at
/// 1e-14 for the checks; unequal beads: Taylor series in long double, and in quadruple precision: the same method
/// twice, which is less independent. Where the two differ by more than 1e-9 the outcome is chaotic: such tuples are not
/// compared, and in scenes that have any only tuples with both references are.
///
/// Times are CPU times of the calling thread: of fixed_step_collision() alone, without the reference solution that a
/// sweep adds for its error bar; of simulate(), with its error bar, for exact. Velocities are those that a solver
/// leaves: it stops once later contacts cannot change eps_eff by more than 1e-3 of the tolerance (1e-13 for fixed
/// steps), which leaves the square root of that in velocities open.
std::vector<PrecisionRow> measure_precision(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec);

/// What the errors are of: "eps_eff", or of what vibrates "h_cm/A0".
std::string_view precision_quantity(const Parameters& parameters);

/// Predicted CPU time of that, s.
double predicted_precision_time(const Parameters& scene, const PrecisionSpec& spec);

/// The study as text, scene by scene. `axes`: the names of the parameters that tell scenes apart.
std::string precision_text(std::span<const PrecisionRow> rows, std::span<const std::string> axes);

/// Draws time against error, log-log: a panel a scene, a curve an integrator, the references' noise as a vertical line,
/// settings with failures as crosses at the right border. Throws as plot_rows() does, and UsageError for more than
/// most_precision_panels scenes.
inline constexpr std::size_t most_precision_panels = 64;
void plot_precision(std::span<const PrecisionRow> rows, std::span<const std::string> axes, const std::string& title,
                    const std::string& path);

/// The same for the rows of an ordinary table: run_time against eps_eff_error, one panel, series by integrator and
/// those of its settings that differ. Rows without a result are crosses at the right border.
void plot_precision_of(std::span<const Row> rows, const std::string& title, const std::string& path);

}  // namespace sigmasweep
