#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

class VibratedSamples;

/// The run of a vibrated column under a law that is not linear.
SimulationResult simulate_nonlinear_on_plate(const Parameters& parameters, ComputeBudget* budget = nullptr);
/// The same seen by the samples, in vibration_units(), relative to the plate; over with the last sample.
void observe_nonlinear_on_plate(const Parameters& parameters, VibratedSamples& samples);

}  // namespace sigmasweep
