#pragma once

#include <span>

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// Result of the run that complete `parameters` describe: a pure function, the same bits for the same parameters on one
/// build. Never throws, never hangs: a tuple that cannot be computed has a status that says so, and parameters that
/// why_invalid() refuses are Status::failed. Where `budget` came to its end the result is Status::time_limit, whatever
/// had been found by then.
SimulationResult simulate(const Parameters& parameters, ComputeBudget* budget = nullptr) noexcept;

/// Results of many tuples at once, results[i] being simulate(parameters[i]) to the bit. Solvers that compute several
/// tuples side by side are faster so. Both spans have the same size; std::invalid_argument if not.
void simulate_many(std::span<const Parameters> parameters, std::span<SimulationResult> results);

}  // namespace sigmasweep
