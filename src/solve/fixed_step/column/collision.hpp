#pragma once

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/fixed_step/step_options.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

namespace sigmasweep {

/// One collision of a column with time step `dt`, in the column's units, by an integrator of fixed step. A contact is
/// closed in the steps in which its overlap is > 0. Status::ok; unstable, when energy comes out of nothing;
/// event_limit. Default work limit: 1e11, some minutes.
Outcome<double> fixed_step_collision(const Column<double>& column, Integrator integrator, double dt,
                                     const RunLimits& limits = {}, const StepOptions& options = {});

}  // namespace sigmasweep
