#include <cstdint>

#include "solve/exact/linear/column.hpp"
#include "solve/exact/power_law/column.hpp"
#include "solve/fixed_step/column/vibrated.hpp"
#include "solve/observer/samples.hpp"
#include "solve/observer/vibration_statistics.hpp"
#include "solve/vibrated.hpp"
#include "solve/vibrated_result.hpp"

namespace sigmasweep {
namespace {

/// Contacts, and contacts moved in steps (some seconds a period), before giving up.
ExactOptions limits(const Parameters& p, double periods) {
  const auto N = static_cast<double>(p.N);
  return {.event_limit = static_cast<std::uint64_t>(periods * (1e5 + 100.0 * N * N)),
          .work_limit = static_cast<std::uint64_t>(periods * (1e8 + 1e7 * N))};
}

/// Until the watcher has seen enough.
template <class Watcher>
Outcome<double> follow(const Parameters& p, const Column<double>& column, const ExactOptions& options,
                       Watcher& watcher) {
  const Plate plate = Plate::of(p, vibration_units(p));
  if (p.integrator != Integrator::exact)
    return fixed_step_vibrated_column(column, plate, p.integrator, 1.0 / p.steps_per_tc, watcher, options.budget);
  if (!column.exponents.linear()) {
    const NonlinearOptions nonlinear{
        .accuracy = 1e-12 * plate.A0 * plate.omega,  // in units of the plate's speed, not of v0
        .event_limit = options.event_limit,
        .work_limit = options.work_limit,
        .budget = options.budget};
    return NonlinearColumn<double, Plate>(column, nonlinear, plate).follow(watcher);
  }
  constexpr int order = TaylorOrder<double>::value;
  if (column.is_uniform()) return ExactColumn<double, 0, false, order, Plate>(column, options, plate).follow(watcher);
  return ExactColumn<double, 0, true, order, Plate>(column, options, plate).follow(watcher);
}

}  // namespace

SimulationResult simulate_vibrated_soft_spheres(const Parameters& p, ComputeBudget* budget) {
  const VibrationUnits units = vibration_units(p);
  const auto column = reduced_column<double>(p);
  VibrationStatistics statistics(p, column, Plate::of(p, units), units);
  ExactOptions options = limits(p, static_cast<double>(p.periods));
  options.budget = budget;
  const Outcome<double> outcome = follow(p, column, options, statistics);
  return vibrated_result(outcome, statistics, units);
}

void observe_vibrated_soft_spheres(const Parameters& p, VibratedSamples& samples) {
  constexpr double max_periods = 1e6;
  follow(p, reduced_column<double>(p), limits(p, max_periods), samples);
}

}  // namespace sigmasweep
