// A closed chain against its normal modes: a second method, by Eigen's eigensolver.
#include "../../src/solve/taylor_group.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "sigmasweep/scene/real.hpp"
#include "sigmasweep/solve/column.hpp"

namespace {

using namespace sigmasweep;

/// x'' = -A (K x + C x') with A = tridiag(-1, w_k, -1), w = 1 at the wall, 2 else: A = V diag(lambda) V^T, and each mode
/// is a damped oscillator y'' + lambda C y' + lambda K y = 0 with y(0) = 0.
std::vector<double> by_modes(int n, double K, double C, const std::vector<double>& u0, double t) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (int k = 0; k < n; ++k) {
    A(k, k) = k == 0 ? 1.0 : 2.0;
    if (k > 0) A(k, k - 1) = A(k - 1, k) = -1.0;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(A);
  const Eigen::VectorXd rates = modes.eigenvectors().transpose() * Eigen::Map<const Eigen::VectorXd>(u0.data(), n);
  Eigen::VectorXd y(n);
  for (int k = 0; k < n; ++k) {
    const double lambda = modes.eigenvalues()[k], mu = lambda * C / 2.0, omega2 = lambda * K - mu * mu;
    const double omega = std::sqrt(std::abs(omega2));
    const double response = omega2 > 0 ? std::sin(omega * t) / omega : std::sinh(omega * t) / omega;
    y[k] = rates[k] * std::exp(-mu * t) * response;
  }
  const Eigen::VectorXd x = modes.eigenvectors() * y;
  return {x.data(), x.data() + n};
}

class ClosedChain : public testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(ClosedChain, MovesAsItsNormalModesDo) {
  const auto [n, eps] = GetParam();
  Parameters p;
  p.N = n;
  p.epsilon = eps;
  const Column<double> column = reduced_column<double>(p);
  std::vector<double> x(std::size_t(n), 0.0), u(std::size_t(n), 0.0);
  for (int k = 0; k < n; ++k) u[std::size_t(k)] = k == 0 ? 1.0 : std::sin(3.0 * k);
  const std::vector<double> u0 = u;

  TaylorGroup<double, 1> group;
  group.resize(std::size_t(n));
  for (int k = 0; k < n; ++k) group.set_law(std::size_t(k), true, column.K, column.C, k == 0 ? 1.0 : 2.0);
  const double fastest = 4.0 * column.C / 2.0 + std::sqrt(std::abs(4.0 * column.C * column.C - 4.0 * column.K)) +
                         std::sqrt(4.0 * column.K);
  const double h = taylor_reach / fastest;
  const int steps = 20;
  for (int step = 0; step < steps; ++step) {
    group.start(0, x, u, h);
    group.expand(h);
    group.evaluate(0, 1.0, x, u);
  }
  const std::vector<double> expected = by_modes(n, column.K, column.C, u0, steps * h);
  for (int k = 0; k < n; ++k)  // 20 steps of a few roundings each, of overlaps up to about 1
    EXPECT_NEAR(x[std::size_t(k)], expected[std::size_t(k)], 2e-14) << "contact " << k;
}

// One, two and many registers; light damping, and over-damped fast modes (eps < 0.043).
INSTANTIATE_TEST_SUITE_P(Sizes, ClosedChain,
                         testing::Combine(testing::Values(1, 2, 7, 8, 9, 16, 17, 40), testing::Values(1.0, 0.9, 0.3, 0.01)));

}  // namespace
