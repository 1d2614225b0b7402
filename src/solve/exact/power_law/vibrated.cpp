#include "solve/exact/power_law/vibrated.hpp"

#include "solve/exact/power_law/column.hpp"
#include "solve/observer/samples.hpp"
#include "solve/run_on_plate.hpp"

namespace sigmasweep {
namespace {

/// Until the watcher has seen enough.
template <class Watcher>
Outcome<double> follow(const Parameters& p, const Column<double>& column, const Plate& plate, double periods,
                       Watcher& watcher, ComputeBudget* budget) {
  const RunLimits limits = plate_limits(p, periods, budget);
  const double accuracy = 1e-12 * plate.A0 * plate.omega;  // in units of the plate's speed, not of v0
  return NonlinearColumn<double, Plate>(column, accuracy, limits, plate).follow(watcher);
}

}  // namespace

SimulationResult simulate_nonlinear_on_plate(const Parameters& p, ComputeBudget* budget) {
  return run_column_on_plate(p, MotionBetween::contacts,
                             [&](const Column<double>& column, const Plate& plate, VibrationStatistics& statistics) {
                               return follow(p, column, plate, static_cast<double>(p.periods), statistics, budget);
                             });
}

void observe_nonlinear_on_plate(const Parameters& p, VibratedSamples& samples) {
  follow(p, reduced_column<double>(p), Plate::of(p, vibration_units(p)), max_recorded_periods, samples, nullptr);
}

}  // namespace sigmasweep
