#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// What is used elsewhere: schemes of fixed time step that take no notice of where in a step a contact opens or closes.
/// That kink of the force, not the order of the scheme, sets their error: it is of first order in dt, and erratic.
namespace sigmasweep {

/// The tuple's collision, of a column or a lattice, with time step tc/steps_per_tc. eps_eff_error is the distance to
/// what `exact` has for it plus the error of that: the time for it is part of this function's time. Where theory says
/// that the step is far too long it is Status::unstable at once: equal beads, and the amplitude of the stiffest mode
/// grows by more than 1e5 within one tc (stability.hpp; of lattices, and above sigma = 0.1, that of a single bead at
/// the wall). With up to 10^3.2 for the closed column collisions were seen to end with a result, if a poor one.
///
/// With steps_per_tc = 0 the step is chosen: from the longest stable one, or tc/20, on it is shortened, the error taken
/// as of first order in it, until eps_eff_error is within the tolerance. Status::tolerance_missed with the smallest
/// error found where steps of tc/1e6, or 1e9/N steps a collision (ten seconds), are not enough.
SimulationResult simulate_fixed_step(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The steps_per_tc that simulate_fixed_step() takes: those given, or what it chose.
double steps_taken(const Parameters& parameters);

}  // namespace sigmasweep
