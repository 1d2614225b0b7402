#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// Collisions by schemes of fixed time step, as other codes use them. The schemes take no notice of where in a step a
/// contact opens or closes. That kink of the force, not the order of the scheme, sets their error: it is of first order
/// in dt, and erratic.
namespace sigmasweep {

/// The tuple's collision, of a column or a lattice, with time step tc/steps_per_tc. eps_eff_error is the distance to
/// the exact solver's eps_eff plus that solver's error; the exact solution is part of this function's run time.
///
/// Status::unstable without a computation where theory says that the step is far too long: for equal beads, if the
/// amplitude of the stiffest mode grows by more than 1e5 within one tc (stability.hpp). The mode is the closed
/// column's, but for lattices and for sigma > 0.1 a single bead's at the wall. With growths up to 10^3.2 collisions
/// were seen to end with a result, if a poor one.
///
/// With steps_per_tc = 0 the step is chosen. It starts as the longest stable one, at most tc/20, and is shortened until
/// eps_eff_error is within the tolerance; the error is taken to be of first order in the step. Where steps of tc/1e6,
/// or 1e9/N steps a collision (ten seconds), are not enough: Status::tolerance_missed with the smallest error found.
SimulationResult simulate_fixed_step(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The steps_per_tc that simulate_fixed_step() uses: the given one, or the one that it chooses.
double steps_taken(const Parameters& parameters);

}  // namespace sigmasweep
