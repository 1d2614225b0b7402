// Long columns: what they cost and what their error bars are worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

double seconds(const Parameters& p) {
  const std::clock_t start = std::clock();
  simulate(p);
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(LargeColumn, AThousandTouchingBeadsAreATupleLikeAnyOther) {
  const Parameters p = soft_column({.epsilon = 0.8, .N = 1000});
  const SimulationResult c = simulate(p);
  ASSERT_EQ(c.status, Status::ok);
  EXPECT_LE(c.eps_eff_error, 1e-12);
  EXPECT_GE(c.contacts, 1000u);
  // 64 bits, to a stop a hundred times later.
  RunLimits limits;
  limits.settle = 1e-15;
  const auto wide = exact_collision(reduced_column<long double>(p), limits);
  const long double expected = energies<long double>(wide.velocity, 1.0L).eps_eff;
  EXPECT_LE(std::abs(double(expected - static_cast<long double>(c.eps_eff))), c.eps_eff_error);
}

// The contact wave needs a time N tc, each step of it N contacts: N^2. The bound on the ratio 400^2/100^2 = 16 leaves a
// factor of three for caches and the machine's other work.
TEST(LargeColumn, CostGrowsAsTheSquareOfTheLength) {
  double short_column = 1e9, long_column = 1e9;
  for (int i = 0; i < 5; ++i) {
    short_column = std::min(short_column, seconds(soft_column({.epsilon = 0.8, .N = 100})));
    long_column = std::min(long_column, seconds(soft_column({.epsilon = 0.8, .N = 400})));
  }
  EXPECT_LE(long_column / short_column, 48.0);
}

// A tolerance a thousand times smaller is a longer tail of contacts that matter little, not another order of cost.
TEST(LargeColumn, CostHardlyDependsOnTheTolerance) {
  for (double epsilon : {0.6, 0.8, 0.9, 0.975}) {
    Parameters loose = soft_column({.epsilon = epsilon, .N = 200}), tight = loose;
    loose.tolerance = 1e-3;
    tight.tolerance = 1e-10;
    EXPECT_LE(seconds(tight), 30.0 * std::max(seconds(loose), 5e-3)) << epsilon;
    EXPECT_EQ(simulate(tight).status, Status::ok) << epsilon;
    EXPECT_LE(std::abs(simulate(tight).eps_eff - simulate(loose).eps_eff), 1e-3) << epsilon;
  }
}

}  // namespace
