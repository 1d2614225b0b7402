#pragma once

#include <memory>

#include "sigmasweep/model/parameters.hpp"
#include "solve/exact/linear/side_by_side/isolated.hpp"

namespace sigmasweep::side_by_side {

/// What columns with the same contacts and the same number of beads have in common.
struct LaneLaw {
  double step;  ///< h, in t_c: 2 over the largest rate of a mode of the column when all its contacts are closed
  double spring, dashpot, wall_spring, wall_dashpot;  ///< K h^2 and C h
  Isolated isolated;
};

/// The law of a tuple. Those that were asked for last are remembered, as their constants are dear.
std::shared_ptr<const LaneLaw> law_of(const Parameters& parameters);

}  // namespace sigmasweep::side_by_side
