#include <cstdint>

#include "exact_column.hpp"
#include "nonlinear_column.hpp"
#include "samples.hpp"
#include "sigmasweep/solve/stability.hpp"
#include "sigmasweep/solve/vibrated.hpp"
#include "vibrated_fixed_step.hpp"
#include "vibration_statistics.hpp"

namespace sigmasweep {
namespace {

/// Contacts before giving up.
std::uint64_t event_limit(const Parameters& p) {
  const auto N = static_cast<std::uint64_t>(p.N), periods = static_cast<std::uint64_t>(p.periods);
  return periods * (100'000 + 100 * N * N);
}

/// Until the watcher has seen enough.
template <class Watcher>
Outcome<double> follow(const Parameters& p, const Column<double>& column, const ExactOptions& options,
                       Watcher& watcher) {
  const Plate plate = Plate::of(p, vibration_units(p));
  if (p.integrator != Integrator::exact)
    return follow_by_fixed_steps(column, plate, p.integrator, 1.0 / p.steps_per_tc, watcher, options.patience);
  if (!column.exponents.linear()) {
    const NonlinearOptions nonlinear{
        .event_limit = options.event_limit, .work_limit = options.work_limit, .patience = options.patience};
    return NonlinearColumn<double, Plate>(column, nonlinear, plate).follow(watcher);
  }
  constexpr int order = TaylorOrder<double>::value;
  if (column.is_uniform()) return ExactColumn<double, 0, false, order, Plate>(column, options, plate).follow(watcher);
  return ExactColumn<double, 0, true, order, Plate>(column, options, plate).follow(watcher);
}

}  // namespace

Collision simulate_vibrated_soft_spheres(const Parameters& p, Patience* patience) {
  const VibrationUnits units = vibration_units(p);
  const auto column = reduced_column<double>(p);
  VibrationStatistics statistics(p, column, Plate::of(p, units), units);
  const ExactOptions options{.event_limit = event_limit(p), .work_limit = UINT64_MAX, .patience = patience};
  const Outcome<double> outcome = follow(p, column, options, statistics);
  Collision c;
  if (p.integrator != Integrator::exact)
    c.predicted_growth = predicted_growth(column, p.integrator, 1.0 / p.steps_per_tc);
  c.contacts = outcome.contacts;
  c.end = outcome.end;
  c.status = outcome.status;
  if (c.status != Status::ok) return c;
  c.x_max = outcome.x_max * units.length;
  c.vibration = statistics.result();
  return c;
}

void watch_vibrated_soft_spheres(const Parameters& p, VibratedSamples& samples) {
  follow(p, reduced_column<double>(p), {.event_limit = UINT64_MAX, .work_limit = UINT64_MAX}, samples);
}

}  // namespace sigmasweep
