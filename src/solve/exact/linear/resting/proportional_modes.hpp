#pragma once

#include "solve/exact/linear/resting/modes.hpp"

namespace sigmasweep {

/// Modes of contacts whose dashpots are proportional to their springs, C = c K. With the symmetric matrix
/// S = sqrt(K) T sqrt(K) = Q mu Q^T each of the n shapes x = K^(-1/2) q is an oscillator lambda^2 + c mu lambda + mu =
/// 0 of its own.
Modes proportional_modes(const Eigen::MatrixXd& T, const Eigen::VectorXd& K, double c);

}  // namespace sigmasweep
