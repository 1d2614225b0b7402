#include "solve/exact/lattice/vibrated.hpp"

#include <algorithm>
#include <cstdint>

#include "solve/exact/lattice/events.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/lattice_statistics.hpp"
#include "solve/run_on_plate.hpp"

namespace sigmasweep {
namespace {

/// Limits of a run from event to event.
RunLimits limits_for(const Parameters& p, double periods, ComputeBudget* budget) {
  constexpr double most = 1e19;
  const auto N = static_cast<double>(p.N);
  return {.event_limit = static_cast<std::uint64_t>(std::min(periods * 1e5 * N, most)),
          .work_limit = static_cast<std::uint64_t>(std::min(periods * (1e9 + 1e7 * N), most)),
          .budget = budget};
}

/// In units of the plate's speed, not of v0.
double accuracy_on(const Plate& plate) { return 1e-10 * plate.A0 * plate.omega; }

}  // namespace

template <class Watcher>
LatticeOutcome<double> follow_lattice(const Lattice<double>& lattice, const Plate& plate, double accuracy,
                                      const RunLimits& limits, Watcher& watcher) {
  return LatticeEvents<double, Plate>(lattice, accuracy, limits, plate).follow(watcher);
}
template LatticeOutcome<double> follow_lattice(const Lattice<double>&, const Plate&, double, const RunLimits&,
                                               LatticeStatistics&);
template LatticeOutcome<double> follow_lattice(const Lattice<double>&, const Plate&, double, const RunLimits&,
                                               VibratedLatticeSamples&);

SimulationResult simulate_lattice_on_plate(const Parameters& p, ComputeBudget* budget) {
  return run_lattice_on_plate(p, MotionBetween::contacts,
                              [&](const Lattice<double>& lattice, const Plate& plate, LatticeStatistics& statistics) {
                                return follow_lattice(lattice, plate, accuracy_on(plate),
                                                      limits_for(p, static_cast<double>(p.periods), budget),
                                                      statistics);
                              });
}

void observe_lattice_on_plate(const Parameters& p, VibratedLatticeSamples& samples) {
  const Plate plate = Plate::of(p, vibration_units(p));
  follow_lattice(reduced_lattice<double>(p), plate, accuracy_on(plate), limits_for(p, max_recorded_periods, nullptr),
                 samples);
}

}  // namespace sigmasweep
