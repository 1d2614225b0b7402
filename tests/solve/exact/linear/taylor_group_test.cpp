// A closed chain against its normal modes: a second method, by Eigen's eigensolver.
#include "solve/exact/linear/taylor_group.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "assembly/column.hpp"
#include "base/quad.hpp"

namespace {

using namespace sigmasweep;

/// x'' = -A (K x + C x') with A = tridiag(-1, w_k, -1), w = 1 at the wall, 2 else: A = V diag(lambda) V^T, and each
/// mode is a damped oscillator y'' + lambda C y' + lambda K y = 0 with y(0) = 0.
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

  TaylorGroup<double, 0> group;
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

// Masses of their own in the place of equal ones of 1: the same motion, but for rounding.
TEST(UnevenChain, WithMassesOfOneMovesAsTheEvenOne) {
  for (std::size_t n : {1, 7, 9, 40}) {
    const Column<double> column = reduced_column<double>({.epsilon = 0.7, .N = std::int64_t(n)});
    TaylorGroup<double, 0> even;
    TaylorGroup<double, 0, true> uneven;
    even.resize(n);
    uneven.resize(n);
    std::vector<double> x(n, 0.0), u(n, 0.0), y, v;
    u[0] = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      even.set_law(k, k % 5 != 4, column.K, column.C, k == 0 ? 1.0 : 2.0);
      uneven.set_law(k, k % 5 != 4, column.K, column.C, k == 0 ? 0.0 : 1.0, 1.0);
    }
    y = x;
    v = u;
    for (int step = 0; step < 5; ++step) {
      even.start(0, x, u, 0.3);
      even.expand(0.3);
      even.evaluate(0, 1.0, x, u);
      uneven.start(0, y, v, 0.3);
      uneven.expand(0.3);
      uneven.evaluate(0, 1.0, y, v);
    }
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(x[k], y[k], 1e-14) << k;
      EXPECT_NEAR(u[k], v[k], 1e-13) << k;
    }
  }
}

// Contacts that rest in touch ahead of the motion are left out: here 400 of them, of which a step reaches 24.
TEST(LongChain, RestsAheadOfTheMotion) {
  constexpr std::size_t n = 400;
  const Column<double> column = reduced_column<double>({.epsilon = 0.7, .N = n});
  TaylorGroup<double, 0> group;
  group.resize(n);
  for (std::size_t k = 0; k < n; ++k) group.set_law(k, true, column.K, column.C, k == 0 ? 1.0 : 2.0);
  std::vector<double> x(n, 0.0), u(n, 0.0);
  u[0] = 1.0;
  const std::vector<double> u0 = u;
  for (int step = 0; step < 40; ++step) {
    group.start(0, x, u, 0.4);
    group.expand(0.4);
    group.evaluate(0, 1.0, x, u);
  }
  const std::vector<double> expected = by_modes(n, column.K, column.C, u0, 16.0);
  for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(x[k], expected[k], 1e-12) << k;  // the eigensolver: N roundings
}

// One, two and many registers; light damping, and over-damped fast modes (eps < 0.043).
INSTANTIATE_TEST_SUITE_P(Sizes, ClosedChain,
                         testing::Combine(testing::Values(1, 2, 7, 8, 9, 16, 17, 40),
                                          testing::Values(1.0, 0.9, 0.3, 0.01)));

}  // namespace
