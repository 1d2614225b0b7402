#pragma once

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// Predicted CPU time of simulate(parameters), s. Only the schedule, the progress bar and `plan` depend on it, no
/// result does. Every solver predicts its own: see solver.cpp in its folder.
double predicted_time(const Parameters& parameters);

}  // namespace sigmasweep
