#include "studies/precision/cases/vibrated.hpp"

#include <cmath>

#include "base/random.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/vibrated_with_accuracy.hpp"
#include "solve/fixed_step/scheme_info.hpp"

namespace sigmasweep {
namespace {

double height(const SimulationResult& c, const Parameters& p) { return c.vibration.h_cm / p.A0; }

ReferenceValue reference_value(const SimulationResult& c, const Parameters& p) {
  return {.known = is_success(c.status), .value = height(c, p)};
}

/// A solver by steps with a local error of `accuracy`.
using SolverBySteps = SimulationResult (*)(const Parameters&, double accuracy, ComputeBudget*);

Reference by_steps(SolverBySteps solve, double accuracy) {
  return [solve, accuracy](const Parameters& p) { return reference_value(solve(p, accuracy, nullptr), p); };
}

/// Columns under the linear law: the integrator `exact` itself.
ReferenceValue by_series(Parameters p) {
  p.integrator = Integrator::exact;
  return reference_value(simulate(p), p);
}

/// Tuples differ in the number of steps, because a whole number of steps fills a period of the plate, and each period
/// begins with a step.
double steps_for(const Parameters& p, double phase) {
  constexpr double max_change = 0.01;
  return p.steps_per_tc * (1.0 + max_change * phase);
}

double evaluations(const Parameters& p) {
  if (p.integrator == Integrator::exact) return PrecisionRow::nan;
  const double steps = std::ceil(p.steps_per_tc / (p.frequency * p.tc)) * static_cast<double>(p.periods);
  return steps * scheme_info(p.integrator).evaluations;
}

/// Both references by steps: the same method at two accuracies.
PrecisionCase case_by_steps(const Parameters& scene, const PrecisionSpec& spec, SolverBySteps solve) {
  PrecisionCase vibrated{
      .tuples = std::vector(spec.tuples, scene), .reference = by_steps(solve, 1e-15), .check = by_steps(solve, 1e-14)};
  for (std::size_t k = 0; k < vibrated.tuples.size(); ++k) {
    Parameters& p = vibrated.tuples[k];
    p.A0 *= 1.0 + scene_change * (2.0 * chance(spec, "A0", k) - 1.0);
    derive_plate_motion(p);
    if (p.random_separation == Flag::yes)
      p.seed = static_cast<std::int64_t>(random_bits(stream_key(spec.seed, "shifts"), k) >> 1);
  }
  vibrated.prepare = [longest = too_long * spec.longest](Parameters p, double phase) -> PreparedRun {
    if (p.integrator != Integrator::exact) p.steps_per_tc = steps_for(p, phase);
    return {.run = [p, longest] {
      ComputeBudget budget(longest);
      const SimulationResult c = simulate(p, &budget);
      return Measurement{.failed = !is_success(c.status), .value = height(c, p), .evaluations = evaluations(p)};
    }};
  };
  return vibrated;
}

}  // namespace

PrecisionCase vibrated_column_case(const Parameters& scene, const PrecisionSpec& spec) {
  PrecisionCase vibrated = case_by_steps(scene, spec, vibrated_column_by_steps);
  if (exponents(scene).linear()) {
    vibrated.check = by_series;
    vibrated.independent = true;
  }
  return vibrated;
}

PrecisionCase vibrated_lattice_case(const Parameters& scene, const PrecisionSpec& spec) {
  return case_by_steps(scene, spec, vibrated_lattice_by_steps);
}

}  // namespace sigmasweep
