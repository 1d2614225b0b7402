#include "studies/precision/measure.hpp"

#include <algorithm>
#include <cmath>

#include "base/thread_clock.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "studies/precision/cases/scene_kind.hpp"
#include "studies/precision/references.hpp"

namespace sigmasweep {
namespace {

/// One integrator at one setting, with the measurements so far.
struct Setting {
  PrecisionRow row;
  std::vector<PreparedRun> runs;
  double errors_took = 0.0;  ///< CPU time of the first round, s
  bool is_exact() const { return row.parameters.integrator == Integrator::exact; }
};

Parameters with_setting(Parameters p, Integrator integrator, double value) {
  p.integrator = integrator;
  if (integrator != Integrator::exact)
    p.steps_per_tc = value;
  else if (value == value)
    p.tolerance = value;
  return p;
}

/// The values of the integrator's setting. An exact solver without a tolerance has one setting, NaN.
std::vector<double> values_of(const Parameters& scene, Integrator integrator, const PrecisionSpec& spec) {
  if (integrator != Integrator::exact) return spec.steps_per_tc;
  return scene_kind(scene).exact_has_tolerance ? spec.tolerances : std::vector{PrecisionRow::nan};
}

std::vector<Setting> settings_of(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec) {
  std::vector<Setting> settings;
  for (const Integrator integrator : spec.integrators)
    for (const double value : values_of(scene, integrator, spec)) {
      Setting& setting = settings.emplace_back();
      setting.row.scene = number;
      setting.row.setting = value;
      setting.row.parameters = with_setting(scene, integrator, value);
    }
  return settings;
}

/// Predicted CPU time of the integrator alone, without the exact solution that a sweep adds to fixed steps; s.
double predicted_alone(const Parameters& p) {
  if (p.integrator == Integrator::exact || !scene_kind(p).fixed_steps_have_reference) return predicted_time(p);
  Parameters exact = p;
  exact.integrator = Integrator::exact;
  return predicted_time(p) - predicted_time(exact);
}

double quantile(std::vector<double>& sorted, double q) {
  if (sorted.empty()) return PrecisionRow::nan;
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::ceil(q * last))];
}

/// Errors of the tuples that have a result.
class Errors {
 public:
  void add(double value, const std::vector<double>& velocity, const ReferenceValue& reference) {
    error_.push_back(static_cast<double>(std::fabs(value - reference.value)));
    if (velocity.empty()) return;
    double worst = 0.0;
    for (std::size_t i = 0; i < velocity.size(); ++i)
      worst = std::max(worst, std::fabs(velocity[i] - reference.velocity[i]));
    velocity_.push_back(worst);
  }
  void summarise(PrecisionRow& row) {
    std::ranges::sort(error_);
    std::ranges::sort(velocity_);
    row.compared = error_.size();
    row.error_median = quantile(error_, 0.5);
    row.error_99 = quantile(error_, 0.99);
    row.error_max = quantile(error_, 1.0);
    row.velocity_median = quantile(velocity_, 0.5);
    row.velocity_max = quantile(velocity_, 1.0);
  }

 private:
  std::vector<double> error_, velocity_;
};

void leave_out(Setting& setting) {
  setting.row.tuples = setting.row.failures = 0;
  setting.runs.clear();
}

void measure_errors(Setting& setting, const PrecisionCase& measured, const References& references,
                    const PrecisionSpec& spec) {
  PrecisionRow& row = setting.row;
  Errors errors;
  double evaluations = 0.0;
  const bool only_phases = measured.tuples.size() == 1 && !setting.is_exact() && references.usable(0);
  const std::size_t count = only_phases ? spec.tuples : references.values.size();
  for (std::size_t k = 0; k < count && (k == 0 || setting.errors_took < spec.seconds); ++k) {
    if (k == 1 && setting.errors_took > spec.longest) return leave_out(setting);
    const std::size_t which = std::min(k, measured.tuples.size() - 1);
    const Parameters p = with_setting(measured.tuples[which], row.parameters.integrator, row.setting);
    const PreparedRun& prepared = setting.runs.emplace_back(measured.prepare(p, chance(spec, "phase", k)));
    const double start = thread_seconds();
    const Measurement found = prepared.run();
    setting.errors_took += thread_seconds() - start;
    evaluations += found.evaluations;
    ++row.tuples;
    if (found.failed)
      ++row.failures;
    else if (references.usable(which))
      errors.add(found.value, prepared.velocity ? prepared.velocity() : found.velocity, references.values[which]);
  }
  errors.summarise(row);
  row.evaluations = evaluations / static_cast<double>(row.tuples);
}

/// Runs all tuples of the setting again; returns the CPU time, s.
double time_once(const Setting& setting) {
  const double start = thread_seconds();
  double sum = 0.0;
  for (const PreparedRun& prepared : setting.runs) sum += prepared.run().value;
  const double took = thread_seconds() - start;
  [[maybe_unused]] volatile double keep = sum;  // the compiler must not remove the computation
  return took;
}

/// Times all settings in turn, so that a disturbance of the machine affects them alike. The round for the errors was
/// the warm-up; if it took too long to be repeated, it is the measurement as well.
void measure_times(std::vector<Setting>& settings, const PrecisionSpec& spec) {
  for (Setting& s : settings)
    if (s.errors_took > spec.repeat_seconds) s.row.run_time = s.errors_took / static_cast<double>(s.row.tuples);
  for (std::uint64_t round = 0; round < spec.repeats; ++round)
    for (Setting& s : settings) {
      const auto rounds_done = static_cast<double>(std::max<std::uint64_t>(round, 1));
      if (s.row.tuples == 0 || rounds_done * s.errors_took > spec.repeat_seconds) continue;
      const double time = time_once(s) / static_cast<double>(s.row.tuples);
      if (!(s.row.run_time <= time)) s.row.run_time = time;
    }
}

}  // namespace

std::string_view precision_quantity(const Parameters& p) { return scene_kind(p).quantity; }

std::vector<PrecisionRow> measure_precision(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec) {
  const PrecisionCase measured = scene_kind(scene).make(scene, spec);
  const References references = find_references(measured, spec);
  std::vector<Setting> settings = settings_of(scene, number, spec);
  for (Setting& setting : settings) {
    PrecisionRow& row = setting.row;
    row.references = references.values.size();
    row.checks = references.checks;
    row.chaotic = references.chaotic;
    row.noise = references.noise;
    row.independent = measured.independent;
    if (predicted_alone(row.parameters) <= too_long * spec.longest) measure_errors(setting, measured, references, spec);
  }
  measure_times(settings, spec);
  std::vector<PrecisionRow> rows;
  for (const Setting& setting : settings) rows.push_back(setting.row);
  return rows;
}

double predicted_precision_time(const Parameters& scene, const PrecisionSpec& spec) {
  double seconds = 2.0 * spec.seconds;
  for (const Setting& setting : settings_of(scene, 0, spec)) {
    const double tuple = predicted_alone(setting.row.parameters);
    const double all = tuple * static_cast<double>(spec.tuples), repeats = all * static_cast<double>(spec.repeats);
    if (tuple > too_long * spec.longest) continue;
    seconds += std::min(tuple > spec.longest ? tuple : all, spec.seconds);
    if (all <= spec.repeat_seconds) seconds += std::min(repeats, 2.0 * spec.repeat_seconds);
  }
  return seconds;
}

}  // namespace sigmasweep
