#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// Vibrated soft spheres by schemes of fixed time step tc/steps_per_tc, or a little less, a whole number of them a
/// period. There is no error bar.
namespace sigmasweep {

class VibratedSamples;
class VibratedLatticeSamples;

SimulationResult fixed_step_column_run_on_plate(const Parameters& parameters, ComputeBudget* budget = nullptr);
SimulationResult fixed_step_lattice_run_on_plate(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The runs seen by the samples, in vibration_units(), relative to the plate; over with the last sample.
void observe_fixed_step_on_plate(const Parameters& parameters, VibratedSamples& samples);
void observe_fixed_step_lattice_on_plate(const Parameters& parameters, VibratedLatticeSamples& samples);

}  // namespace sigmasweep
