#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/studies/precision/study.hpp"

/// What a precision study must know of a kind of scene: the study itself knows no solver.
namespace sigmasweep {

/// What a reference says of a tuple.
struct ReferenceValue {
  bool known = false;
  long double value = 0.0L;        ///< eps_eff; of what vibrates h_cm/A0
  std::vector<double> velocity{};  ///< final ones, all components, units of v0; of what vibrates none
};

/// What an integrator does.
struct Measurement {
  bool failed = true;
  double value = PrecisionRow::nan;
  std::vector<double> velocity{};
  double evaluations = PrecisionRow::nan;  ///< of all forces; NaN where they are not counted
};

/// A tuple with an integrator and its setting, all made ready.
struct PreparedRun {
  std::function<Measurement()> run;                 ///< what is timed
  std::function<std::vector<double>()> velocity{};  ///< what run() leaves out, if there is any
};

using Reference = std::function<ReferenceValue(const Parameters&)>;

struct PrecisionCase {
  std::vector<Parameters> tuples;  ///< a single one if only the phases of fixed steps are left to change
  Reference reference{}, check{};
  bool check_is_better = false;  ///< check is only for the first few
  bool independent = false;      ///< they are two methods
  /// Of a tuple that has integrator and setting; `phase`, in [0, 1): where in a step the first contact is to fall.
  std::function<PreparedRun(const Parameters&, double phase)> trial{};
};

PrecisionCase column_subject(const Parameters& scene, const PrecisionSpec& spec);
PrecisionCase lattice_subject(const Parameters& scene, const PrecisionSpec& spec);
/// Columns and lattices.
PrecisionCase vibrated_subject(const Parameters& scene, const PrecisionSpec& spec);

/// Random changes of a scene are up to this part of it.
inline constexpr double scene_change = 1e-3;

/// Random in [0, 1), for tuple k.
double chance(const PrecisionSpec& spec, const char* what, std::uint64_t k);

/// The scene with other sigmas, s0 follows; just one where that is 0.
std::vector<Parameters> with_other_sigmas(const Parameters& scene, const PrecisionSpec& spec);

/// Predictions are good to an order of magnitude: only settings predicted to take this many times `longest` are left
/// out without a try of one tuple.
inline constexpr double too_long = 20.0;

}  // namespace sigmasweep
