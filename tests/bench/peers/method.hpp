#pragma once

#include <functional>
#include <span>
#include <string>

#include "bench/peers/tuples.hpp"

namespace sigmasweep::peers {

/// Computes eps_eff of the tuples that it was made for; NaN where there is no result. This is what is timed.
using Run = std::function<void(std::span<double> eps_eff)>;

/// A way to compute a collision, at one of its settings.
struct Method {
  std::string name, setting;
  /// Makes a run: whatever does not depend on the method's speed, such as the reading of parameters, is done here.
  std::function<Run(std::span<const Tuple>)> prepare;
  bool side_by_side = false;  ///< several tuples at a time, so that their order matters
};

/// A method that computes the tuples one by one, by eps_eff(tuple).
Method one_by_one(std::string name, std::string setting, std::function<double(const Tuple&)> eps_eff);

}  // namespace sigmasweep::peers
