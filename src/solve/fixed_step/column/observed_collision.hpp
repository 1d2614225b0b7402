#pragma once

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/samples.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// Computes a column's collision with time step `dt` until the last sample is taken. Time counts from the start of the
/// fall.
void observe_fixed_step(const Column<double>& column, Integrator integrator, double dt, Samples& samples);

}  // namespace sigmasweep
