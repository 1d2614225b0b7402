#pragma once

#include "assembly/column.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

/// A second opinion on the linear law, for columns of equal beads: a run of closed contacts moves as its normal modes,
/// each a damped oscillator with a closed solution, and events are found by short steps with bounds of what happens
/// within. It shares no code with the exact solver, is slower, and serves as its independent reference.
namespace sigmasweep {

/// One collision of a column in reduced units (speed and tc about 1): beads of one mass, the linear law, any gaps,
/// walls of either kind. A contact opens when its overlap falls to -1e-18 N instead of 0, for rounding to have no say
/// there. Overlaps between are not looked at, so x_max is NaN. Limits of its own: 100,000 + 20 N^2
/// contacts; 2e9 modes evaluated, summed over all contacts: minutes. Throws std::invalid_argument for other columns.
Outcome<long double> normal_modes_collision(const Column<long double>& column,
                                            const RunLimits& limits = {.settle = 0.0});

}  // namespace sigmasweep
