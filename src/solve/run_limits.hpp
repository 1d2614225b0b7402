#pragma once

#include <cstdint>

#include "sigmasweep/base/budget.hpp"

namespace sigmasweep {

/// Limits of one run of a solver: when its result is good enough, and when it gives up.
struct RunLimits {
  double settle = 1e-13;            ///< stop once later collisions can change eps_eff by less than this; 0: never
  std::uint64_t event_limit = 0;    ///< contacts, or collisions, before giving up; 0: the solver's own limit
  std::uint64_t work_limit = 0;     ///< contacts moved, summed over the steps, before giving up; 0: the solver's own
  ComputeBudget* budget = nullptr;  ///< asked now and then; Status::time_limit where it is over
};

}  // namespace sigmasweep
