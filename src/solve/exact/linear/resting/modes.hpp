#pragma once

#include <Eigen/Dense>

namespace sigmasweep {

/// The 2n modes V_j e^(lambda_j t) of n contacts that stay closed, x'' + T (C x' + K x) = 0.
struct Modes {
  Eigen::VectorXcd lambda;
  Eigen::MatrixXcd V, inverse;  ///< rows of V: n overlaps, then n rates; inverse: V^-1
};

Eigen::MatrixXcd inverse_of(const Eigen::MatrixXcd& V);

}  // namespace sigmasweep
