#pragma once

#include <vector>

#include "bench/peers/method.hpp"

namespace sigmasweep::peers {

/// Boost.odeint's adaptive dopri5 and rkf78 on the right-hand side as it is, with its jumps where contacts open and
/// close: the error control has to find them.
std::vector<Method> odeint_plain_methods();

}  // namespace sigmasweep::peers
