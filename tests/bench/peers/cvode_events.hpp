#pragma once

#include <vector>

#include "bench/peers/method.hpp"

namespace sigmasweep::peers {

/// CVODE (SUNDIALS) with its own rootfinding; none if it was not there when this was built.
std::vector<Method> cvode_methods();

}  // namespace sigmasweep::peers
