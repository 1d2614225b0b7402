#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "studies/precision/study.hpp"

/// The parts of a precision study that depend on the kind of scene.
namespace sigmasweep {

/// The result that a reference has for a tuple.
struct ReferenceValue {
  bool known = false;
  long double value = 0.0L;        ///< eps_eff, or h_cm/A0 on a plate
  std::vector<double> velocity{};  ///< all components of the final velocities, units of v0; empty on a plate
};

/// The result that an integrator has for a tuple.
struct Measurement {
  bool failed = true;
  double value = PrecisionRow::nan;
  std::vector<double> velocity{};
  double evaluations = PrecisionRow::nan;  ///< number of evaluations of all forces; NaN if they are not counted
};

/// A tuple with an integrator and its setting, ready to be run.
struct PreparedRun {
  std::function<Measurement()> run;                 ///< the part that is timed
  std::function<std::vector<double>()> velocity{};  ///< computes the velocities if run() does not
};

using Reference = std::function<ReferenceValue(const Parameters&)>;

/// A scene for measurements: its tuples, references and runs.
struct PrecisionCase {
  std::vector<Parameters> tuples;  ///< a single one if tuples can only differ in the phases of fixed steps
  Reference reference{}, check{};
  bool check_is_better = false;  ///< `check` is the reference if both are computed
  bool independent = false;      ///< reference and check are different methods
  /// Prepares a tuple with integrator and setting. `phase`, in [0, 1), is the phase of a step at which the first
  /// contact occurs.
  std::function<PreparedRun(const Parameters&, double phase)> prepare{};
};

/// Largest relative change of a scene's parameters in its tuples.
inline constexpr double scene_change = 1e-3;

/// A random number in [0, 1) for tuple k, independent for each purpose.
double chance(const PrecisionSpec& spec, const char* purpose, std::uint64_t k);

/// Tuples of the scene with different sigma and s0; a single tuple if sigma is 0.
std::vector<Parameters> with_other_sigmas(const Parameters& scene, const PrecisionSpec& spec);

/// A setting is left out without a try if its predicted time is this many times `longest`. Predictions are right to an
/// order of magnitude.
inline constexpr double too_long = 20.0;

}  // namespace sigmasweep
