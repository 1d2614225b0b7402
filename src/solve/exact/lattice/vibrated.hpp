#pragma once

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

namespace sigmasweep {

class VibratedLatticeSamples;

/// A lattice in a container that vibrates as a whole under gravity, moved from event to event until the watcher has
/// seen enough.
template <class Watcher>
LatticeOutcome<double> follow_lattice(const Lattice<double>& lattice, const Plate& plate, double accuracy,
                                      const RunLimits& limits, Watcher& watcher);

/// The run of the tuple's lattice.
SimulationResult simulate_lattice_on_plate(const Parameters& parameters, ComputeBudget* budget = nullptr);
/// The same seen by the samples, in vibration_units(), relative to the plate; over with the last sample.
void observe_lattice_on_plate(const Parameters& parameters, VibratedLatticeSamples& samples);

}  // namespace sigmasweep
