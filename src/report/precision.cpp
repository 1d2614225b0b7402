#include "sigmasweep/report/precision.hpp"

#include <algorithm>
#include <cmath>

#include "precision_references.hpp"
#include "sigmasweep/scene/law.hpp"
#include "sigmasweep/scene/random.hpp"
#include "sigmasweep/solve/exact.hpp"
#include "sigmasweep/solve/fixed_step.hpp"
#include "sigmasweep/solve/nonlinear.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/solve/thread_clock.hpp"
#include "sigmasweep/sweep/cost.hpp"

namespace sigmasweep {
namespace {

constexpr double sigma_change = 1e-3;
/// Predictions are good to an order of magnitude: only settings predicted to take this many times `longest` are left
/// out without a try of one tuple.
constexpr double too_long = 20.0;

/// One integrator at one setting, with what is known of it so far.
struct Setting {
  PrecisionRow row;
  std::vector<Parameters> tuples;        ///< with integrator and setting
  std::vector<Column<double>> columns;   ///< fixed steps: with the wall further away
  double errors_took = 0.0;              ///< CPU time of the first round, s
  bool is_exact() const { return row.parameters.integrator == Integrator::exact; }
  double dt() const { return 1.0 / row.setting; }
};

/// The scene, with another sigma; s0 follows.
std::vector<Parameters> tuples_of(const Parameters& scene, const PrecisionSpec& spec) {
  const std::uint64_t key = stream_key(spec.seed, "sigma");
  std::vector<Parameters> tuples(scene.sigma > 0.0 ? spec.tuples : 1, scene);
  for (std::size_t k = 0; k < tuples.size(); ++k) {
    tuples[k].sigma *= 1.0 + sigma_change * (2.0 * unit_interval(random_bits(key, k)) - 1.0);
    tuples[k].s0 = tuples[k].sigma * tuples[k].v0 * tuples[k].tc;
  }
  return tuples;
}

/// The column, its wall further away by a random part of what it flies in a step.
Column<double> shifted(const Parameters& tuple, double dt, const PrecisionSpec& spec, std::size_t k) {
  Column<double> column = reduced_column<double>(tuple);
  if (column.gaps.empty()) column.gaps.assign(column.contacts(), column.gap);
  column.gaps[0] += unit_interval(random_bits(stream_key(spec.seed, "phase"), k)) * dt * column.speed;
  return column;
}

Setting make_setting(const Parameters& scene, Integrator integrator, double value, std::uint64_t number) {
  Setting setting;
  setting.row.scene = number;
  setting.row.setting = value;
  setting.row.parameters = scene;
  setting.row.parameters.integrator = integrator;
  (integrator == Integrator::exact ? setting.row.parameters.tolerance : setting.row.parameters.steps_per_tc) = value;
  return setting;
}

std::vector<Setting> settings_of(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec) {
  std::vector<Setting> settings;
  for (const Integrator integrator : spec.integrators)
    for (const double value : integrator == Integrator::exact ? spec.tolerances : spec.steps_per_tc)
      settings.push_back(make_setting(scene, integrator, value, number));
  return settings;
}

/// Of the solver alone: what a sweep adds to a scheme of fixed steps is the exact solution.
double predicted_alone(const Parameters& p) {
  if (p.integrator == Integrator::exact) return predicted_time(p);
  Parameters exact = p;
  exact.integrator = Integrator::exact;
  return predicted_time(p) - predicted_time(exact);
}

/// The final velocities of the exact solver as it stops for this tolerance. In double: where simulate() needs more
/// than that, its eps_eff is better than these.
std::vector<double> exact_velocities(const Parameters& p) {
  const Column<double> column = reduced_column<double>(p);
  const double settle = 1e-3 * p.tolerance;
  if (column.exponents.linear()) return exact_collision(column, {.settle = settle}).velocity;
  return nonlinear_collision(column, {.accuracy = std::max(1e-3 * p.tolerance, 1e-15), .settle = settle}).velocity;
}

double quantile(std::vector<double>& sorted, double q) {
  if (sorted.empty()) return PrecisionRow::nan;
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::ceil(q * last))];
}

/// Errors of the tuples that have a result.
class Errors {
 public:
  void add(double eps_eff, const std::vector<double>& velocity, const Answer& answer) {
    error_.push_back(static_cast<double>(std::fabs(eps_eff - answer.eps_eff)));
    double worst = 0.0;
    for (std::size_t i = 0; i < velocity.size(); ++i)
      worst = std::max(worst, std::fabs(velocity[i] - answer.velocity[i]));
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
  setting.tuples.clear();
  setting.columns.clear();
}

void measure_errors(Setting& setting, const std::vector<Parameters>& tuples, const References& references,
                    const PrecisionSpec& spec) {
  PrecisionRow& row = setting.row;
  Errors errors;
  double evaluations = 0.0;
  // Without a gap only the phase of the steps is left to change.
  const bool only_phases = tuples.size() == 1 && !setting.is_exact() && references.usable(0);
  const std::size_t count = only_phases ? spec.tuples : references.answers.size();
  for (std::size_t k = 0; k < count && (k == 0 || setting.errors_took < spec.seconds); ++k) {
    if (k == 1 && setting.errors_took > spec.longest) return leave_out(setting);
    const std::size_t which = std::min(k, tuples.size() - 1);
    Parameters p = row.parameters;
    p.sigma = tuples[which].sigma;
    p.s0 = tuples[which].s0;
    double eps_eff;
    bool failed;
    std::vector<double> velocity;
    if (setting.is_exact()) {
      const double start = thread_seconds();
      const Collision c = simulate(p);
      setting.errors_took += thread_seconds() - start;
      failed = !is_success(c.status);
      eps_eff = c.eps_eff;
      velocity = exact_velocities(p);
      setting.tuples.push_back(p);
    } else {
      setting.columns.push_back(shifted(p, setting.dt(), spec, k));
      const Column<double>& column = setting.columns.back();
      std::uint64_t steps = 0;
      const double start = thread_seconds();
      const auto outcome = fixed_step_collision(column, p.integrator, setting.dt(), {.steps = &steps});
      setting.errors_took += thread_seconds() - start;
      failed = !is_success(outcome.status);
      eps_eff = energies<double>(outcome.velocity, column.speed, column.mass).eps_eff;
      velocity = outcome.velocity;
      evaluations += static_cast<double>(steps) * (p.integrator == Integrator::rk4 ? 4.0 : 1.0);
    }
    ++row.tuples;
    if (failed) ++row.failures;
    else if (references.usable(which)) errors.add(eps_eff, velocity, references.answers[which]);
  }
  errors.summarise(row);
  if (!setting.is_exact()) row.evaluations = evaluations / static_cast<double>(row.tuples);
}

/// All tuples of the setting once more; CPU time, s.
double time_once(const Setting& setting) {
  const double start = thread_seconds();
  double sum = 0.0;
  for (const Parameters& p : setting.tuples) sum += simulate(p).eps_eff;
  for (const Column<double>& column : setting.columns)
    sum += fixed_step_collision(column, setting.row.parameters.integrator, setting.dt()).velocity[0];
  const double took = thread_seconds() - start;
  [[maybe_unused]] volatile double keep = sum;  // or the compiler might leave it all out
  return took;
}

/// Round robin, so that what disturbs the machine hits all settings alike. The round for the errors was the warm-up;
/// where it was too long to be repeated, it also was the measurement.
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

std::vector<PrecisionRow> measure_precision(const Parameters& scene, std::uint64_t number, const PrecisionSpec& spec) {
  const std::vector<Parameters> tuples = tuples_of(scene, spec);
  const References references = find_references(tuples, spec);
  std::vector<Setting> settings = settings_of(scene, number, spec);
  for (Setting& setting : settings) {
    PrecisionRow& row = setting.row;
    row.references = references.answers.size();
    row.checks = references.checks;
    row.chaotic = references.chaotic;
    row.noise = references.noise;
    row.independent = references.independent;
    if (predicted_alone(row.parameters) <= too_long * spec.longest) measure_errors(setting, tuples, references, spec);
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
