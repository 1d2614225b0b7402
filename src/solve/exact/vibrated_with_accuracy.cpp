#include "solve/exact/vibrated_with_accuracy.hpp"

#include <cstdint>

#include "solve/exact/lattice/vibrated.hpp"
#include "solve/exact/power_law/column.hpp"
#include "solve/run_on_plate.hpp"

namespace sigmasweep {
namespace {

/// Some minutes.
constexpr std::uint64_t max_work = 1'000'000'000, max_contacts = 1'000'000'000;

}  // namespace

SimulationResult vibrated_lattice_by_steps(const Parameters& p, double accuracy, ComputeBudget* budget) {
  return run_lattice_on_plate(
      p, MotionBetween::contacts,
      [&](const Lattice<double>& lattice, const Plate& plate, LatticeStatistics& statistics) {
        const RunLimits limits{.event_limit = max_contacts, .work_limit = max_work, .budget = budget};
        return follow_lattice(lattice, plate, accuracy * plate.A0 * plate.omega, limits, statistics);
      });
}

SimulationResult vibrated_column_by_steps(const Parameters& p, double accuracy, ComputeBudget* budget) {
  return run_column_on_plate(
      p, MotionBetween::contacts,
      [&](const Column<double>& column, const Plate& plate, VibrationStatistics& statistics) {
        const RunLimits limits{.event_limit = max_contacts, .work_limit = max_work, .budget = budget};
        return NonlinearColumn<double, Plate>(column, accuracy * plate.A0 * plate.omega, limits, plate)
            .follow(statistics);
      });
}

}  // namespace sigmasweep
