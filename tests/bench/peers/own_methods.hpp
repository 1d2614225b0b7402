#pragma once

#include <vector>

#include "bench/peers/method.hpp"

namespace sigmasweep::peers {

/// sigmasweep's own: `exact` with its error bar, tuple by tuple and side by side, and the bare schemes of fixed step.
std::vector<Method> own_methods();

}  // namespace sigmasweep::peers
