#include <gtest/gtest.h>

#include <cmath>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "support/parameters.hpp"
#include "support/reference_values.hpp"

/// Hard spheres whose collisions are elastic where they follow on each other within tc (the TC model).
namespace sigmasweep {
namespace {

Parameters tc_model(std::int64_t N, double epsilon, double sigma, Wall wall = Wall::paper, EdRule rule = EdRule::tc) {
  return hard_column({.sigma = sigma, .epsilon = epsilon, .N = N, .wall = wall, .ed_rule = rule});
}

class TcReference : public testing::TestWithParam<reference::HardTc> {};

TEST_P(TcReference, IsReproduced) {
  const reference::HardTc& r = GetParam();
  const SimulationResult c = simulate(tc_model(r.N, r.epsilon, r.sigma, r.wall));
  EXPECT_NEAR(c.eps_eff, r.eps_eff, c.eps_eff_error + r.uncertainty);
  if (!r.well_conditioned) return;
  EXPECT_EQ(c.status, Status::ok);
  EXPECT_NEAR(c.eps_eff, r.eps_eff, 1e-13);  // what is left to dissipate at the stop: a thousandth of the tolerance
  const auto column = reduced_column<double>(tc_model(r.N, r.epsilon, r.sigma, r.wall));
  const auto to_the_end = hard_sphere_collision(column, {.rule = EdRule::tc}, {.settle = 0.0});
  EXPECT_EQ(to_the_end.end, End::separated);
  EXPECT_EQ(to_the_end.contacts, r.collisions);
}

INSTANTIATE_TEST_SUITE_P(Columns, TcReference, testing::ValuesIn(reference::hard_tc), [](const auto& run) {
  const auto& r = run.param;
  return std::string("N") + std::to_string(r.N) + "_eps" + std::to_string(std::lround(100 * r.epsilon)) + "_sigma" +
         std::to_string(std::lround(100 * r.sigma)) + "_" + std::string(name_of(r.wall));
});

TEST(TcModel, TouchingColumnLosesInItsFirstCollisionOnly) {
  for (const std::int64_t N : {1, 2, 10, 40})
    for (const double epsilon : {0.2, 0.6, 0.9}) {
      const SimulationResult c = simulate(tc_model(N, epsilon, 0.0, Wall::matched));
      EXPECT_EQ(c.status, Status::ok);
      // One bead turns round with epsilon, the others' energy stays: (N - 1 + epsilon^2)/N of it.
      const double n = static_cast<double>(N);
      EXPECT_NEAR(c.eps_eff, std::sqrt((n - 1.0 + epsilon * epsilon) / n), 1e-14);
      EXPECT_NEAR(simulate(tc_model(N, epsilon, 1e-9, Wall::matched)).eps_eff, c.eps_eff, 1e-14);
    }
}

TEST(TcModel, LongFlightsMakeItTheOtherRule) {
  for (const Wall wall : {Wall::paper, Wall::matched}) {
    const SimulationResult tc = simulate(tc_model(10, 0.9, 1e4, wall));
    const SimulationResult lrv = simulate(tc_model(10, 0.9, 1e4, wall, EdRule::lrv));
    EXPECT_EQ(tc.eps_eff, lrv.eps_eff);
    EXPECT_EQ(tc.contacts, lrv.contacts);
  }
}

TEST(TcModel, NeverCollapsesAndAlwaysEnds) {
  for (const std::int64_t N : {2, 3, 10, 30})
    for (const double epsilon : {1e-6, 0.1, 0.6, 0.9})
      for (const double sigma : {0.0, 1e-3, 0.3, 3.0, 100.0, 1e8, 1e14}) {
        const SimulationResult c = simulate(tc_model(N, epsilon, sigma));
        ASSERT_TRUE(c.status == Status::ok || c.status == Status::tolerance_missed)
            << "N=" << N << " eps=" << epsilon << " sigma=" << sigma << " " << name_of(c.status);
        EXPECT_NE(c.end, End::none);
        EXPECT_GE(c.eps_eff, 0.0);
        EXPECT_LE(c.eps_eff, 1.0);
      }
}

}  // namespace
}  // namespace sigmasweep
