#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energies.hpp"
#include "assembly/energy_balance.hpp"
#include "solve/fixed_step/driver.hpp"

namespace sigmasweep {

/// When a column's collision is over: nothing approaches, or later contacts can change eps_eff by less than `settle`.
class ColumnEnding {
 public:
  static constexpr std::uint64_t steps_between_outlooks = 65536;
  static constexpr std::uint64_t max_work = 100'000'000'000;  ///< steps times contacts: some minutes
  static std::uint64_t event_limit(std::size_t /*beads*/) { return std::numeric_limits<std::uint64_t>::max(); }

  explicit ColumnEnding(double settle) : settle_(settle) {}

  void note(double /*now*/, bool /*any_closed*/) {}
  Verdict quiet(double /*now*/) const { return {}; }
  Verdict by_energy(double /*energy*/, double /*start_energy*/) const { return {}; }

  /// Overdamped beads that creep, and stick together for good, end by how little they have left to lose.
  template <class System>
  Verdict look_ahead(const System& system, double /*now*/, double /*start_energy*/) const {
    const double* x = system.scheme().x();
    std::vector<std::uint8_t> closed(system.beads());
    for (std::size_t k = 0; k < system.beads(); ++k) closed[k] = x[k] > 0.0;
    std::vector<double> v = system.velocities();
    for (double& each : v) each /= system.dt();
    const EnergyBalance<double> energy(system.column(), closed, {x, system.beads()}, std::move(v));
    return {.end = energy.remaining() < settle_ ? End::settled : End::none};
  }

  template <class System>
  FreeFlightAhead free_flight(const System& system, double /*now*/, double /*start_energy*/) const {
    const double *x = system.scheme().x(), *u = system.scheme().u();
    double steps = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < system.beads(); ++k)
      if (u[k] > 0.0) steps = std::min(steps, -x[k] / u[k]);
    if (steps == std::numeric_limits<double>::infinity()) return {.verdict = {.end = End::separated}};
    if (steps < 2.0) return {};
    const double left = residual_dissipation<double>(system.velocities(), system.equation().u[0], system.column().mass);
    return {.steps = steps, .verdict = {.end = left < settle_ ? End::settled : End::none}};
  }

 private:
  double settle_;
};

}  // namespace sigmasweep
