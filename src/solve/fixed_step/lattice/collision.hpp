#pragma once

#include "assembly/lattice.hpp"
#include "solve/fixed_step/step_options.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

namespace sigmasweep {

/// One collision of a lattice with time step `dt`, in the lattice's units, by an integrator of fixed step and with
/// neighbour lists. No notice is taken of where in a step a contact opens or closes. Status::ok; unstable, when energy
/// comes out of nothing; event_limit. Default limits: 100,000 + 1,000 N contacts, and a work of 1e10, some minutes.
LatticeOutcome<double> fixed_step_lattice_collision(const Lattice<double>& lattice, Integrator integrator, double dt,
                                                    const RunLimits& limits = {}, const StepOptions& options = {});

}  // namespace sigmasweep
