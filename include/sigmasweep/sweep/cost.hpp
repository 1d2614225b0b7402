#pragma once

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// Predicted CPU time of simulate(parameters), s: from the number of contacts and steps that sigma, N and epsilon
/// imply. Only the schedule, the progress bar and `plan` depend on it, no result does.
double predicted_time(const Parameters& parameters);

}  // namespace sigmasweep
