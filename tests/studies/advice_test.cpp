#include "studies/advice/advice.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

Parameters column(std::int64_t N, double epsilon, double s0) {
  Parameters p{.v0 = 0.5, .tc = 2e-5, .s0 = s0};
  p.N = N;
  p.epsilon = epsilon;
  return completed(p);
}

double off(Parameters p, double sigma) {
  p.sigma = sigma;
  const Parameters soft = complete(p, GapParameter::sigma);
  Parameters hard = soft;
  hard.method = Method::ed;
  const double of_hard = simulate(hard).eps_eff;
  return std::abs(simulate(soft).eps_eff - of_hard) / of_hard;
}

TEST(Advice, HardFromIsWhereFivePercentAreReached) {
  for (const std::int64_t N : {2, 5, 10})
    for (const double epsilon : {0.85, 0.95}) {
      const Parameters p = column(N, epsilon, 1e-6);
      const Advice advice = advise(p, 1e-6);
      ASSERT_TRUE(advice.hard_from) << N << " " << epsilon;
      const double from = *advice.hard_from;
      EXPECT_NEAR(off(p, from), Advice::near, 1e-4) << N << " " << epsilon;
      EXPECT_GT(off(p, 0.98 * from), Advice::near);
      for (const double more : {1.1, 2.0, 10.0, 1e3}) EXPECT_LT(off(p, more * from), Advice::near) << more;
      EXPECT_DOUBLE_EQ(*advice.hard_tc(), p.s0 / (p.v0 * from));
      EXPECT_EQ(advice.is_near_hard(), p.sigma >= from);
    }
}

TEST(Advice, NoStiffnessIsEnoughWhereHardBeadsCollapse) {
  const Advice advice = advise(column(10, 0.6, 1e-6), 1e-6);
  EXPECT_EQ(advice.hard.status, Status::collapsed);
  EXPECT_FALSE(advice.hard_from);
}

TEST(Advice, OneBeadIsAlwaysLikeAHardOne) {
  const Advice advice = advise(column(1, 0.9, 1e-6), 1e-6);
  ASSERT_TRUE(advice.hard_from);
  EXPECT_EQ(*advice.hard_from, 0.0);
  EXPECT_FALSE(advice.hard_tc());
  EXPECT_TRUE(advice.is_near_hard());
}

TEST(Advice, BeadsInTouchAreSoftForAnyStiffness) {
  const Advice advice = advise(column(10, 0.9, 0.0), 1e-6);
  EXPECT_FALSE(advice.is_near_hard());
  EXPECT_FALSE(advice.hard_tc());
}

TEST(Advice, SpringsAreThoseOfThePair) {
  const Parameters p = column(10, 0.9, 1e-6);
  const double mass = 3e-6;
  const Advice advice = advise(p, mass);
  EXPECT_NEAR(advice.stiffness, stiffness_of(mass, p.tc, p.epsilon), 1e-12 * advice.stiffness);
  EXPECT_NEAR(tc_of(mass, advice.stiffness, p.epsilon), p.tc, 1e-12 * p.tc);
  EXPECT_NEAR(advice.dashpot, -mass * std::log(p.epsilon) / p.tc, 1e-12 * advice.dashpot);  // D_n m, Eq. (7)
}

TEST(Advice, ErrorsOfStepsFall) {
  const Advice advice = advise(column(10, 0.9, 1e-6), 1e-6);
  EXPECT_LT(advice.steps.back().error, 0.1 * advice.steps.front().error);
  for (const Advice::Step& step : advice.steps) EXPECT_TRUE(step.stable) << step.steps_per_tc;
}

}  // namespace
}  // namespace sigmasweep
