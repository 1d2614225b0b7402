#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// The collision that `parameters` describe: a pure function, the same bits for the same parameters on one build.
/// Never throws, never hangs: what cannot be computed is a status, and parameters that why_invalid() refuses are
/// failed. Where `budget` came to its end it is Status::time_limit, whatever had been found by then.
SimulationResult simulate(const Parameters& parameters, ComputeBudget* budget = nullptr) noexcept;

}  // namespace sigmasweep
