#pragma once

#include "solve/exact/linear/resting/modes.hpp"

namespace sigmasweep {

/// Modes of contacts with any dashpots, by the system of first order x' = u, u' = -TK x - TC u.
Modes general_modes(const Eigen::MatrixXd& TK, const Eigen::MatrixXd& TC);

}  // namespace sigmasweep
