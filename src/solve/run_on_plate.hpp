#pragma once

#include <cstdint>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/observer/lattice_statistics.hpp"
#include "solve/observer/vibration_statistics.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

/// Runs of soft spheres on a vibrated plate, Sec. V: they start at rest relative to it when it begins to move as z0(t)
/// = A0 sin(2 pi f t), Eq. (1), and are averaged over all periods after the transient.
namespace sigmasweep {

/// Result of a run on a plate: x_max, vibration, contacts, end and status.
template <class AnyOutcome, class Statistics>
SimulationResult vibrated_result(const AnyOutcome& outcome, const Statistics& statistics, const VibrationUnits& units) {
  SimulationResult c;
  c.contacts = outcome.contacts;
  c.end = outcome.end;
  c.status = outcome.status;
  if (c.status != Status::ok) return c;
  c.x_max = outcome.x_max * units.length;
  c.vibration = statistics.result();
  return c;
}

/// `follow(column, plate, statistics)` moves the column until the statistics have seen enough, and returns its outcome.
template <class Follow>
SimulationResult run_column_on_plate(const Parameters& p, MotionBetween motion, const Follow& follow) {
  const VibrationUnits units = vibration_units(p);
  const auto column = reduced_column<double>(p);
  const Plate plate = Plate::of(p, units);
  VibrationStatistics statistics(p, column, plate, units, motion);
  return vibrated_result(follow(column, plate, statistics), statistics, units);
}

/// The same for a lattice in a vibrated container.
template <class Follow>
SimulationResult run_lattice_on_plate(const Parameters& p, MotionBetween motion, const Follow& follow) {
  const VibrationUnits units = vibration_units(p);
  const auto lattice = reduced_lattice<double>(p);
  const Plate plate = Plate::of(p, units);
  LatticeStatistics statistics(p, lattice, plate, units, motion);
  return vibrated_result(follow(lattice, plate, statistics), statistics, units);
}

/// Periods after which a recorded run gives up at the latest.
inline constexpr double max_recorded_periods = 1e6;

/// Limits of a column's run from contact event to contact event: some seconds a period.
inline RunLimits plate_limits(const Parameters& p, double periods, ComputeBudget* budget) {
  const auto N = static_cast<double>(p.N);
  return {.event_limit = static_cast<std::uint64_t>(periods * (1e5 + 100.0 * N * N)),
          .work_limit = static_cast<std::uint64_t>(periods * (1e8 + 1e7 * N)),
          .budget = budget};
}

}  // namespace sigmasweep
