#pragma once

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/samples.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// A column's collision with time step `dt`, recorded until the last sample is taken. The clock starts with the fall.
void observe_fixed_step(const Column<double>& column, Integrator integrator, double dt, Samples& samples);

}  // namespace sigmasweep
