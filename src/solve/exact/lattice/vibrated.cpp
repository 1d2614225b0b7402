#include "solve/exact/lattice/vibrated.hpp"

#include <algorithm>
#include <cstdint>

#include "solve/observer/lattice_samples.hpp"
#include "solve/run_on_plate.hpp"

namespace sigmasweep {
namespace {

LatticeOptions options_for(const Parameters& p, const Plate& plate, double periods, ComputeBudget* budget) {
  constexpr double most = 1e19;
  const auto N = static_cast<double>(p.N);
  return {.accuracy = 1e-10 * plate.A0 * plate.omega,  // of the plate's speed, not of v0
          .event_limit = static_cast<std::uint64_t>(std::min(periods * 1e5 * N, most)),
          .work_limit = static_cast<std::uint64_t>(std::min(periods * (1e9 + 1e7 * N), most)),
          .budget = budget};
}

}  // namespace

SimulationResult simulate_lattice_on_plate(const Parameters& p, ComputeBudget* budget) {
  return run_lattice_on_plate(p, [&](const Lattice<double>& lattice, const Plate& plate,
                                     LatticeStatistics& statistics) {
    return follow_lattice(lattice, plate, options_for(p, plate, static_cast<double>(p.periods), budget), statistics);
  });
}

void observe_lattice_on_plate(const Parameters& p, VibratedLatticeSamples& samples) {
  const Plate plate = Plate::of(p, vibration_units(p));
  follow_lattice(reduced_lattice<double>(p), plate, options_for(p, plate, max_recorded_periods, nullptr), samples);
}

}  // namespace sigmasweep
