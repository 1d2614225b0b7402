#pragma once

#include "assembly/lattice.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

namespace sigmasweep {

class LatticeSamples;

/// One collision of a lattice with the wall, by the default integrator: beads in no contact fly in closed form,
/// clusters of beads that touch are moved by DOP853 each on its own, and every contact's closing and opening is
/// located. Only contacts cost time. `accuracy`: local error of a step, in units of the speed and of speed times tc.
/// Real: double or long double.
///
/// End::quiet where quiet_time() > 0. Otherwise End::separated, when nothing touches and no two beads within 0.6 d of
/// each other, and no bead and wall, approach (beads that drift sideways to a wall further away do not count); or
/// End::settled, when the beads that approach can lose next to nothing; that is also the end of overdamped beads that
/// creep. Limits of its own: 100,000 + 1,000 N contacts; 1e10 + 2e7 N beads and contacts moved in stages of steps, some
/// minutes.
template <class Real>
LatticeOutcome<Real> lattice_collision(const Lattice<Real>& lattice, double accuracy = 1e-12,
                                       const RunLimits& limits = {});

/// The lattice's collision seen by the samples, and over with the last of them. The clock starts with the fall.
void observe_lattice(const Lattice<double>& lattice, LatticeSamples& samples);

/// The tuple's collision with an error bar.
SimulationResult simulate_lattice(const Parameters& parameters, ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
