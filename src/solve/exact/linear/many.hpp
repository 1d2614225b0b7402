#pragma once

#include <span>

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// Collisions of columns under the linear law: side by side where that is possible, alone where it is not, or where it
/// misses the tolerance. The same bits for a tuple alone and among others.
namespace sigmasweep {

SimulationResult simulate_linear(const Parameters& parameters, ComputeBudget* budget);
/// Leaves Status::not_run where the tuple must be computed alone.
void simulate_linear_many(std::span<const Parameters> parameters, std::span<SimulationResult> results);

}  // namespace sigmasweep
