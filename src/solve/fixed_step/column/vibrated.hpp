#pragma once

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// A vibrated column by steps of at most `dt`, a whole number of them a period, until the watcher (VibrationStatistics
/// or VibratedSamples) has seen enough. Works are sums over the steps: the energies balance as well as the steps are
/// short. Outcome: x_max, contacts, end and status; Status::unstable where energy comes out of nothing.
template <class Watcher>
Outcome<double> follow_by_fixed_steps(const Column<double>& column, const Plate& plate, Integrator integrator,
                                      double dt, Watcher& watcher, ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
