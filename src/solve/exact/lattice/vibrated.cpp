#include "solve/exact/lattice/vibrated.hpp"

#include <algorithm>
#include <cstdint>

#include "solve/fixed_step/lattice/vibrated.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/lattice_statistics.hpp"
#include "solve/vibrated.hpp"
#include "solve/vibrated_result.hpp"

namespace sigmasweep {
namespace {

/// Until the watcher has seen enough.
template <class Watcher>
LatticeOutcome<double> follow(const Parameters& p, const Lattice<double>& lattice, double periods, Watcher& watcher,
                              ComputeBudget* budget) {
  const Plate plate = Plate::of(p, vibration_units(p));
  if (p.integrator != Integrator::exact)
    return fixed_step_vibrated_lattice(lattice, plate, p.integrator, 1.0 / p.steps_per_tc, watcher, budget);
  constexpr double most = 1e19;
  const auto N = static_cast<double>(p.N);
  const LatticeOptions options{.accuracy = 1e-10 * plate.A0 * plate.omega,  // of the plate's speed, not of v0
                               .event_limit = static_cast<std::uint64_t>(std::min(periods * 1e5 * N, most)),
                               .work_limit = static_cast<std::uint64_t>(std::min(periods * (1e9 + 1e7 * N), most)),
                               .budget = budget};
  return follow_lattice(lattice, plate, options, watcher);
}

}  // namespace

SimulationResult simulate_vibrated_lattice(const Parameters& p, ComputeBudget* budget) {
  const VibrationUnits units = vibration_units(p);
  const auto lattice = reduced_lattice<double>(p);
  LatticeStatistics statistics(p, lattice, Plate::of(p, units), units);
  const LatticeOutcome<double> outcome = follow(p, lattice, static_cast<double>(p.periods), statistics, budget);
  return vibrated_result(outcome, statistics, units);
}

void observe_vibrated_lattice(const Parameters& p, LatticeSamples& samples) {
  constexpr double max_periods = 1e6;
  VibratedLatticeSamples vibrated(samples, Plate::of(p, vibration_units(p)).period());
  follow(p, reduced_lattice<double>(p), max_periods, vibrated, nullptr);
}

}  // namespace sigmasweep
