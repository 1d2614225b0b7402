#pragma once

#include <vector>

#include "bench/peers/located_events.hpp"
#include "bench/peers/method.hpp"

namespace sigmasweep::peers {

/// Boost.odeint with its dense output, on which closing and opening contacts are located; the solver is started again
/// after each, with the step that it had. `tolerance`: the solver's, relative and absolute.
Collision odeint_with_events(double sigma, double tolerance);

std::vector<Method> odeint_event_methods();

}  // namespace sigmasweep::peers
