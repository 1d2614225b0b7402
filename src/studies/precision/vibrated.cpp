#include <cmath>

#include "base/random.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/vibrated_with_accuracy.hpp"
#include "studies/precision/subject.hpp"

/// Columns and lattices on a plate that vibrates.
namespace sigmasweep {
namespace {

double height(const SimulationResult& c, const Parameters& p) { return c.vibration.h_cm / p.A0; }

ReferenceValue answer(const SimulationResult& c, const Parameters& p) {
  return {.known = is_success(c.status), .value = height(c, p)};
}

Reference by_steps(double accuracy) {
  return [accuracy](const Parameters& p) {
    return answer(is_lattice(p) ? vibrated_lattice_by_steps(p, accuracy) : vibrated_column_by_steps(p, accuracy), p);
  };
}

/// Columns under the linear law: the integrator `exact` itself.
ReferenceValue by_series(Parameters p) {
  p.integrator = Integrator::exact;
  return answer(simulate(p), p);
}

/// Whole numbers of steps fill a period, which begins at the same phase of the plate: it is their number that differs.
double steps_for(const Parameters& p, double phase) {
  constexpr double most = 0.01;
  return p.steps_per_tc * (1.0 + most * phase);
}

double evaluations(const Parameters& p) {
  if (p.integrator == Integrator::exact) return PrecisionRow::nan;
  const double steps = std::ceil(p.steps_per_tc / (p.frequency * p.tc)) * static_cast<double>(p.periods);
  return steps * (p.integrator == Integrator::rk4 ? 4.0 : 1.0);
}

}  // namespace

PrecisionCase vibrated_subject(const Parameters& scene, const PrecisionSpec& spec) {
  PrecisionCase vibrated{
      .tuples = std::vector(spec.tuples, scene), .reference = by_steps(1e-15), .check = by_steps(1e-14)};
  for (std::size_t k = 0; k < vibrated.tuples.size(); ++k) {
    Parameters& p = vibrated.tuples[k];
    p.A0 *= 1.0 + scene_change * (2.0 * chance(spec, "A0", k) - 1.0);
    derive_plate_motion(p);
    if (p.random_separation == Flag::yes)
      p.seed = static_cast<std::int64_t>(random_bits(stream_key(spec.seed, "shifts"), k) >> 1);
  }
  if (!is_lattice(scene) && exponents(scene).linear()) {
    vibrated.check = by_series;
    vibrated.independent = true;
  }
  vibrated.trial = [longest = too_long * spec.longest](Parameters p, double phase) -> PreparedRun {
    if (p.integrator != Integrator::exact) p.steps_per_tc = steps_for(p, phase);
    return {.run = [p, longest] {
      ComputeBudget budget(longest);
      const SimulationResult c = simulate(p, &budget);
      return Measurement{.failed = !is_success(c.status), .value = height(c, p), .evaluations = evaluations(p)};
    }};
  };
  return vibrated;
}

}  // namespace sigmasweep
