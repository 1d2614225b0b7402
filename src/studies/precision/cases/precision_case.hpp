#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "studies/precision/study.hpp"

/// The parts of a precision study that depend on the kind of scene: the study itself knows no solver.
namespace sigmasweep {

/// The result that a reference has for a tuple.
struct ReferenceValue {
  bool known = false;
  long double value = 0.0L;        ///< eps_eff; of vibrated scenes h_cm/A0
  std::vector<double> velocity{};  ///< all components of the final velocities, units of v0; of vibrated scenes none
};

/// The result that an integrator has for a tuple.
struct Measurement {
  bool failed = true;
  double value = PrecisionRow::nan;
  std::vector<double> velocity{};
  double evaluations = PrecisionRow::nan;  ///< of all forces; NaN where they are not counted
};

/// A tuple with an integrator and its setting, ready to be run.
struct PreparedRun {
  std::function<Measurement()> run;                 ///< the part that is timed
  std::function<std::vector<double>()> velocity{};  ///< the velocities, where run() leaves them out
};

using Reference = std::function<ReferenceValue(const Parameters&)>;

/// A scene as it is measured: its tuples, its references and its runs.
struct PrecisionCase {
  std::vector<Parameters> tuples;  ///< a single one if tuples can only differ in the phases of fixed steps
  Reference reference{}, check{};
  bool check_is_better = false;  ///< where both are computed, `check` is the reference
  bool independent = false;      ///< reference and check are different methods
  /// Prepares a tuple that has integrator and setting. `phase`, in [0, 1): where in a step the first contact is to
  /// fall.
  std::function<PreparedRun(const Parameters&, double phase)> prepare{};
};

/// The random changes of a scene's parameters are up to this fraction of them.
inline constexpr double scene_change = 1e-3;

/// A random number in [0, 1), for tuple k; each purpose has its own.
double chance(const PrecisionSpec& spec, const char* purpose, std::uint64_t k);

/// The scene with other sigmas, and s0 to match. A single tuple where sigma is 0.
std::vector<Parameters> with_other_sigmas(const Parameters& scene, const PrecisionSpec& spec);

/// A setting is left out without a try of one tuple where it is predicted to take this many times `longest`.
/// Predictions are good to an order of magnitude.
inline constexpr double too_long = 20.0;

}  // namespace sigmasweep
