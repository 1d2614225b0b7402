#pragma once

#include <memory>

#include "assembly/column.hpp"
#include "solve/exact/linear/side_by_side/isolated.hpp"

namespace sigmasweep::side_by_side {

/// The law of a column's contacts, in units of its step.
struct LaneLaw {
  double step = 0.0;                       ///< in t_c
  double spring = 0.0, wall_spring = 0.0;  ///< K h^2
  Isolated isolated;
};

/// Equal beads: many columns of a sweep have one law, and the last few are remembered.
std::shared_ptr<const LaneLaw> law_of(const Parameters& parameters);

}  // namespace sigmasweep::side_by_side
