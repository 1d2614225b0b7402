#pragma once

#include <cstdint>

#include "assembly/column.hpp"
#include "sigmasweep/model/result.hpp"

/// A second opinion on the linear law, for columns of equal beads: a run of closed contacts moves as its normal modes,
/// each a damped oscillator with a closed solution, and events are found by short steps with bounds of what happens
/// within. It shares no code with the exact solver, is slower, and serves as its independent reference.
namespace sigmasweep {

struct NormalModesOptions {
  double settle = 0.0;            ///< stop once later collisions can change eps_eff by less than this; 0: never
  std::uint64_t event_limit = 0;  ///< contacts before giving up; 0: 100,000 + 20 N^2
  std::uint64_t work_limit = 2'000'000'000;  ///< modes evaluated, summed over all contacts, before giving up: minutes
};

/// One collision of a column in reduced units (speed and tc about 1): beads of one mass, the linear law, any gaps,
/// walls of either kind. A contact opens when its overlap falls to -1e-18 N instead of 0, for rounding to have no say
/// there. Overlaps between are not looked at, so x_max is NaN. Throws std::invalid_argument for other columns.
Outcome<long double> normal_modes_collision(const Column<long double>& column, const NormalModesOptions& options = {});

}  // namespace sigmasweep
