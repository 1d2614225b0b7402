#include "solve/exact/linear/resting/proportional_modes.hpp"

#include <complex>
#include <tuple>

namespace sigmasweep {

using Complex = std::complex<double>;

Modes proportional_modes(const Eigen::MatrixXd& T, const Eigen::VectorXd& K, double c) {
  const Eigen::Index n = K.size();
  const Eigen::VectorXd root = K.cwiseSqrt();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(root.asDiagonal() * T * root.asDiagonal());
  const Eigen::MatrixXd shape = root.cwiseInverse().asDiagonal() * solver.eigenvectors();
  const Eigen::MatrixXd analysis = solver.eigenvectors().transpose() * root.asDiagonal();
  Modes modes{Eigen::VectorXcd(2 * n), Eigen::MatrixXcd(2 * n, 2 * n), Eigen::MatrixXcd(2 * n, 2 * n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const double mu = solver.eigenvalues()[j], half = 0.5 * c * mu;
    const Complex apart = std::sqrt(Complex(half * half - mu));
    // The slower of two real rates without cancellation.
    const Complex fast = -half - apart, slow = half * half > mu ? mu / fast : -half + apart;
    for (const auto& [column, rate, other] : {std::tuple(j, fast, slow), std::tuple(n + j, slow, fast)}) {
      modes.lambda[column] = rate;
      modes.V.col(column) << shape.col(j).cast<Complex>(), rate * shape.col(j).cast<Complex>();
      modes.inverse.row(column) << -other / (rate - other) * analysis.row(j).cast<Complex>(),
          analysis.row(j).cast<Complex>() / (rate - other);
    }
  }
  return modes;
}

}  // namespace sigmasweep
