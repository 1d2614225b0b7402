#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "bench/peers/method.hpp"

namespace sigmasweep::peers {

/// Measures all methods alternately: in each round each of them computes each group once, so that a drift of the
/// machine meets all of them alike. Methods that work side by side also get the whole set in one call, in two orders:
/// like tuples beside each other, and interleaved.
///
/// A list of cells, one a method, setting and group: `sigma` or `order` names the group; `seconds`: CPU time of a
/// tuple, the least of the rounds; `error_max`, `error_median`: of |eps_eff - true value|; `failed`: tuples without a
/// result.
nlohmann::json measure(std::span<const Method> methods, std::span<const Group> groups, int rounds);

}  // namespace sigmasweep::peers
