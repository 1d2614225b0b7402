#pragma once

#include "assembly/lattice.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// Computes a lattice's collision with time step `dt` until the last sample is taken. Time counts from the start of the
/// fall.
void observe_fixed_step_lattice(const Lattice<double>& lattice, Integrator integrator, double dt,
                                LatticeSamples& samples);

}  // namespace sigmasweep
