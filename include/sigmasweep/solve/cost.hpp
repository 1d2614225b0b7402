#pragma once

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// Predicted CPU time of simulate(parameters), s. Schedule, progress bar and `plan` depend on it, results do not. Each
/// solver has its own prediction, in the solver.cpp of its folder.
double predicted_time(const Parameters& parameters);

}  // namespace sigmasweep
