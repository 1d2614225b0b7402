// Columns whose parts live on very different scales: masses, walls and gaps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/piecewise_linear.hpp"
#include "support/soft_column.hpp"

namespace {

using namespace sigmasweep;

template <class Real>
double eps_eff(const Column<Real>& column) {
  const auto outcome = exact_collision(column);
  EXPECT_EQ(outcome.status, Status::ok);
  return eps_eff(column, outcome);
}

/// A wall with `ratio` times a pair's spring; its dashpot so that the wall's damping ratio stays what it is.
template <class Real>
Column<Real> with_wall(const Parameters& p, double ratio) {
  Column<Real> column = reduced_column<Real>(p);
  column.K_wall = column.K * Real(ratio);
  column.C_wall = column.C * std::sqrt(Real(ratio));
  return column;
}

// A step of the wall's contact is up to 1e4 times shorter than one of a pair's. Long double has 2000 times finer
// roundings, which both columns make about as many times as there are steps: 1e-11.
TEST(Stiff, WallsOfAnyStiffness) {
  for (const double ratio : {1e-8, 1e-4, 0.1, 3.0, 1e4, 1e8})
    for (const std::int64_t N : {1, 2, 3, 6})
      for (const double epsilon : {1.0, 0.9, 0.5})
        for (const double sigma : {0.0, 0.5}) {
          const Parameters p = soft_column(N, epsilon, sigma);
          const double value = eps_eff(with_wall<double>(p, ratio));
          SCOPED_TRACE(testing::Message()
                       << "ratio " << ratio << " N " << N << " eps " << epsilon << " sigma " << sigma);
          if (epsilon == 1.0) {
            EXPECT_NEAR(value, 1.0, 1e-11);
          }
          if (epsilon == 0.5 || (N > 2 && std::fabs(std::log10(ratio)) > 4.5)) continue;  // long double is slow
          EXPECT_NEAR(value, eps_eff(with_wall<long double>(p, ratio)), 1e-10);
        }
}

// Against the matrix exponential, whose steps are set by the stiffer of the two.
TEST(Stiff, WallsMoveAsTheMatrixExponentialSays) {
  for (const double ratio : {0.05, 5.0, 100.0}) {
    const auto column = with_wall<double>(soft_column(3, 0.7, 0.1), ratio);
    const auto expected = piecewise_linear::Solver(column, 0.02 / std::sqrt(std::max(1.0, ratio))).run();
    const auto outcome = exact_collision(column);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(outcome.velocity[k], expected.velocity[k], 1e-11) << ratio;
  }
}

// The work of the dashpots by quadrature of the reference's motion. 1e-11: where it stops.
TEST(Stiff, LosesWhatTheDashpotsTake) {
  for (const double epsilon : {0.5, 1e-3, 1e-6})
    for (const std::int64_t N : {1, 2, 3})
      for (const double sigma : {0.0, 0.5}) {
        const auto column = reduced_column<double>(soft_column(N, epsilon, sigma));
        const auto expected = piecewise_linear::Solver(column, 0.005, true).run();
        const double kept = eps_eff(column);
        EXPECT_NEAR(1.0 - kept * kept, 2.0 * expected.dashpot_work / double(N), 1e-11)
            << epsilon << " " << N << " " << sigma;
      }
}

// A very stiff wall is a hard one: instant, with the wall's restitution. What is left is its contact time, 1e-4 tc.
TEST(Stiff, AStiffWallIsAHardWall) {
  const Parameters p = soft_column(1, 0.6, 0.0);
  for (const double ratio : {1.0, 1e8})
    EXPECT_NEAR(eps_eff(with_wall<double>(p, ratio)), reduced_column<double>(p).eps_wall, 1e-13);
}

// Diameters uniform in d +- 0.995 d: the lightest bead is up to 6e7 times lighter than the heaviest.
TEST(Stiff, MassesMayDifferByAMillion) {
  double largest = 1.0;
  for (std::int64_t seed = 0; seed < 20; ++seed) {
    Parameters p = soft_column(12, 0.9, seed % 2 == 0 ? 0.0 : 0.3);
    p.width = 1.99 * p.d;
    p.seed = seed;
    ASSERT_EQ(why_invalid(p), "");
    const auto column = reduced_column<double>(p);
    const auto [light, heavy] = std::minmax_element(column.mass.begin(), column.mass.end());
    largest = std::max(largest, *heavy / *light);
    const SimulationResult c = simulate(p);
    ASSERT_TRUE(c.status == Status::ok || c.status == Status::tolerance_missed) << seed;
    if (c.status != Status::ok) continue;
    const auto wide = reduced_column<long double>(p);
    const auto outcome = exact_collision(wide, {.settle = 1e-16});
    ASSERT_EQ(outcome.status, Status::ok);
    const auto true_value = energies<long double>(outcome.velocity, 1.0L, wide.mass).eps_eff;
    EXPECT_LE(std::fabs(double(true_value - (long double)(c.eps_eff))), c.eps_eff_error + 1e-15) << seed;
  }
  EXPECT_GT(largest, 1e6);
}

// Gaps on any scale beside each other: a gap too small to matter is none.
TEST(Stiff, MixedGaps) {
  for (const double epsilon : {1.0, 0.9, 0.3}) {
    Column<double> column = reduced_column<double>(soft_column(6, epsilon, 0.2));
    column.gaps = {0.2, 1e-300, 0.2, 1e-16, 0.0, 1.5};
    Column<double> closed = column;
    closed.gaps = {0.2, 0.0, 0.2, 0.0, 0.0, 1.5};
    EXPECT_NEAR(eps_eff(column), eps_eff(closed), 1e-12) << epsilon;
    const auto expected = piecewise_linear::Solver(closed, 0.01).run();
    const auto outcome = exact_collision(column);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(outcome.velocity[k], expected.velocity[k], 1e-11) << epsilon;
  }
}

}  // namespace
