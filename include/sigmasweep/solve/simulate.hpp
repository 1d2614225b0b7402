#pragma once

#include <span>

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// The result of a tuple, whose parameters must be complete. It is a pure function: one build gives the same bits for
/// the same parameters. It never throws and never hangs. A tuple that cannot be computed has a status with the reason;
/// parameters that why_invalid() refuses have Status::failed. If `budget` ends, the status is time_limit.
SimulationResult simulate(const Parameters& parameters, ComputeBudget* budget = nullptr) noexcept;

/// The results of several tuples, each of them simulate(parameters[i], &budgets[i]) to the bit; without budgets there
/// are no limits. It is faster with solvers that compute several tuples side by side. Where a budget was stopped, that
/// result means nothing, and results with Status::not_run were not computed any more. Throws std::invalid_argument
/// unless all spans have the same size.
void simulate_many(std::span<const Parameters> parameters, std::span<SimulationResult> results,
                   std::span<ComputeBudget> budgets = {});

/// The quick part of simulate_many(): the results of those tuples that a solver computes side by side. All others have
/// Status::not_run, those that take long among them.
void simulate_together(std::span<const Parameters> parameters, std::span<SimulationResult> results);

}  // namespace sigmasweep
