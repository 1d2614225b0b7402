#include <cstdint>

#include "sigmasweep/model/geometry.hpp"
#include "solve/exact/lattice/vibrated.hpp"
#include "solve/exact/power_law/column.hpp"
#include "solve/observer/lattice_statistics.hpp"
#include "solve/observer/vibration_statistics.hpp"
#include "solve/vibrated.hpp"
#include "solve/vibrated_result.hpp"

namespace sigmasweep {
namespace {

/// Some minutes.
constexpr std::uint64_t max_work = 1'000'000'000, max_contacts = 1'000'000'000;

SimulationResult lattice_by_steps(const Parameters& p, double accuracy, ComputeBudget* budget) {
  const VibrationUnits units = vibration_units(p);
  const Plate plate = Plate::of(p, units);
  const auto lattice = reduced_lattice<double>(p);
  LatticeStatistics statistics(p, lattice, plate, units);
  const LatticeOptions options{.accuracy = accuracy * plate.A0 * plate.omega,
                               .event_limit = max_contacts,
                               .work_limit = max_work,
                               .budget = budget};
  return vibrated_result(follow_lattice(lattice, plate, options, statistics), statistics, units);
}

SimulationResult column_by_steps(const Parameters& p, double accuracy, ComputeBudget* budget) {
  const VibrationUnits units = vibration_units(p);
  const Plate plate = Plate::of(p, units);
  const auto column = reduced_column<double>(p);
  VibrationStatistics statistics(p, column, plate, units);
  const NonlinearOptions options{.accuracy = accuracy * plate.A0 * plate.omega,
                                 .event_limit = max_contacts,
                                 .work_limit = max_work,
                                 .budget = budget};
  const Outcome<double> outcome = NonlinearColumn<double, Plate>(column, options, plate).follow(statistics);
  return vibrated_result(outcome, statistics, units);
}

}  // namespace

SimulationResult vibrated_by_steps(const Parameters& p, double accuracy, ComputeBudget* budget) {
  return is_lattice(p) ? lattice_by_steps(p, accuracy, budget) : column_by_steps(p, accuracy, budget);
}

}  // namespace sigmasweep
