#pragma once

#include <cstdint>

#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/solve/column.hpp"

/// What is used elsewhere: schemes of fixed time step that take no notice of where in a step a contact opens or closes.
/// That kink of the force, not the order of the scheme, sets their error: it is of first order in dt, and erratic.
namespace sigmasweep {

struct FixedStepOptions {
  double settle = 1e-13;           ///< stop once later contacts can change eps_eff by less than this; 0: never
  double step_limit = 0.0;         ///< steps before giving up; 0: 1e11/N, some minutes
  bool skip_free_flight = true;    ///< cross free flight in one go, by a whole number of steps; for tests
};

/// One collision with time step `dt`, in the column's units. `integrator`: gear5, verlet or rk4. A contact is closed
/// in the steps where its overlap is > 0. Status::ok; unstable, when energy comes out of nothing; event_limit.
Outcome<double> fixed_step_collision(const Column<double>& column, Integrator integrator, double dt,
                                     const FixedStepOptions& options = {});

/// The tuple's collision with time step tc/steps_per_tc. eps_eff_error is the distance to simulate_exact() of the same
/// tuple plus the error of that: the time for it is part of this function's time, not of fixed_step_collision's.
Collision simulate_fixed_step(const Parameters& parameters);

}  // namespace sigmasweep
