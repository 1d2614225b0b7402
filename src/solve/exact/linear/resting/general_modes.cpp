#include "solve/exact/linear/resting/general_modes.hpp"

namespace sigmasweep {

Modes general_modes(const Eigen::MatrixXd& TK, const Eigen::MatrixXd& TC) {
  const Eigen::Index n = TK.rows();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -TK;
  A.bottomRightCorner(n, n) = -TC;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  Modes modes{solver.eigenvalues(), solver.eigenvectors(), {}};
  modes.inverse = inverse_of(modes.V);
  return modes;
}

}  // namespace sigmasweep
