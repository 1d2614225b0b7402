#pragma once

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/samples.hpp"
#include "solve/observer/vibration_statistics.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// A vibrated column by steps of at most `dt`, a whole number of them a period, until the observer has seen all
/// periods. Works are sums over the steps: the energies balance as well as the steps are short. Outcome: x_max,
/// contacts, end, status, and the last velocities relative to the plate; Status::unstable where energy comes out of
/// nothing.
Outcome<double> fixed_step_vibrated_column(const Column<double>& column, const Plate& plate, Integrator integrator,
                                           double dt, VibrationStatistics& statistics, ComputeBudget* budget = nullptr);
/// The same with samples of the motion (vibrated_samples.cpp).
Outcome<double> fixed_step_vibrated_column(const Column<double>& column, const Plate& plate, Integrator integrator,
                                           double dt, VibratedSamples& samples, ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
