#include "solve/fixed_step/collision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "sigmasweep/model/names.hpp"
#include "solve/fixed_step/column/collision.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

class FixedStep : public testing::TestWithParam<Integrator> {};

INSTANTIATE_TEST_SUITE_P(Schemes, FixedStep,
                         testing::Values(Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog),
                         [](const auto& scheme) { return std::string(name_of(scheme.param)); });

Column<double> column(std::int64_t N, double eps, double sigma, Wall wall = Wall::paper) {
  Parameters p;
  p.N = N;
  p.epsilon = eps;
  p.sigma = sigma;
  p.wall = wall;
  return reduced_column<double>(p);
}

TEST_P(FixedStep, OneBeadComesBackWithTheRestitutionOfTheWall) {
  for (const double eps : {0.5, 0.9, 1.0})
    for (const double sigma : {0.0, 0.37, 123.4}) {
      // eps_wall of the paper's wall from 18-digit arithmetic where it is known, exp(-L) for the matched one.
      const auto matched = fixed_step_collision(column(1, eps, sigma, Wall::matched), GetParam(), 1.0 / 2000);
      EXPECT_EQ(matched.status, Status::ok);
      EXPECT_EQ(matched.end, End::separated);
      EXPECT_EQ(matched.contacts, 1u);
      ASSERT_EQ(matched.velocity.size(), 1u);
      // First order: dt times the largest jump of the acceleration, 2 L v0/tc, and of its slope.
      EXPECT_NEAR(matched.velocity[0], eps, 2e-3);
      EXPECT_NEAR(matched.t_k, 1.0, 2e-3);
    }
  const auto paper = fixed_step_collision(column(1, 0.9, 0.0), GetParam(), 1.0 / 5000);
  EXPECT_NEAR(paper.velocity[0], 0.928225857266253452, 2e-4);
}

TEST_P(FixedStep, CrossingFreeFlightInOneGoIsTheSameAsSteppingThroughIt) {
  const unsigned seed = 20240611;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> sigma(0.5, 4.0), steps(40.0, 80.0);
  for (int i = 0; i < 10; ++i) {
    const Column<double> c = column(4, 0.8, sigma(random));
    const double dt = 1.0 / steps(random);
    const auto skipped = fixed_step_collision(c, GetParam(), dt, {}, {.free_flight = FreeFlight::skipped});
    const auto stepped = fixed_step_collision(c, GetParam(), dt, {}, {.free_flight = FreeFlight::stepped});
    ASSERT_EQ(skipped.status, Status::ok);
    EXPECT_EQ(skipped.contacts, stepped.contacts);
    EXPECT_EQ(skipped.end, stepped.end);
    // Rounding of some hundred additions, amplified by the collisions.
    EXPECT_NEAR(skipped.t_k, stepped.t_k, 1e-9);
    EXPECT_NEAR(skipped.x_max, stepped.x_max, 1e-10);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(skipped.velocity[k], stepped.velocity[k], 1e-10);
  }
}

TEST_P(FixedStep, RawSIUnitsGiveTheSame) {
  Parameters p{.v0 = 0.2, .tc = 4e-6, .s0 = 1e-6, .epsilon = 0.8, .N = 5};
  p = completed(p);
  const auto si = fixed_step_collision(si_column<double>(p), GetParam(), p.tc / 73.0);
  const auto reduced = fixed_step_collision(reduced_column<double>(p), GetParam(), 1.0 / 73.0);
  EXPECT_EQ(si.contacts, reduced.contacts);
  // Rounding, amplified by the collisions.
  EXPECT_NEAR(si.t_k / p.tc, reduced.t_k, 1e-10);
  EXPECT_NEAR(si.x_max / (p.v0 * p.tc), reduced.x_max, 1e-11);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(si.velocity[k] / p.v0, reduced.velocity[k], 1e-11);
}

// Beads of their own masses, gaps and laws against the integrators that locate the contacts.
TEST_P(FixedStep, UnequalBeadsAndAllLawsMoveAsTheDefaultIntegratorSays) {
  for (Law law : {Law::hooke, Law::hertz, Law::hertz_kuwabara_kono, Law::taguchi, Law::power})
    for (double width : {0.0, 0.8e-3}) {
      Parameters p{.sigma = 0.1, .epsilon = 0.85, .beta = 0.3, .gamma = 0.2, .width = width, .N = 5, .seed = 3};
      p.law = law;
      p.random_separation = Flag::yes;
      p.integrator = GetParam();
      p.steps_per_tc = 2017.0;
      const SimulationResult c = simulate_fixed_step(completed(p));
      ASSERT_EQ(c.status, Status::ok) << name_of(law);
      // First order: twenty times less than at tc/100, where the worst single contact has 1.7e-3.
      EXPECT_LE(c.eps_eff_error, 1e-4) << name_of(law) << " " << width;
    }
}

TEST_P(FixedStep, OverdampedBeadsThatStickTogetherComeToAnEnd) {
  Column<double> c = column(2, 0.05, 0.0);
  c.mass = {400.0, 400.0};
  const auto o = fixed_step_collision(c, GetParam(), 1.0 / 400);
  EXPECT_EQ(o.status, Status::ok);
  EXPECT_EQ(o.end, End::settled);
  EXPECT_NEAR(o.velocity[0], o.velocity[1], 1e-6);
}

TEST_P(FixedStep, WideGapsNeedNoMoreStepsThanNarrowOnes) {
  const auto wide = fixed_step_collision(column(3, 0.9, 1e6), GetParam(), 0.01, {.work_limit = 3 * 5000});
  EXPECT_EQ(wide.status, Status::ok);
  const auto widest = fixed_step_collision(column(3, 0.9, 1e300), GetParam(), 0.01, {.work_limit = 3 * 5000});
  EXPECT_EQ(widest.status, Status::ok);
  EXPECT_NEAR(widest.velocity[2], wide.velocity[2], 0.02);  // two phases of a first-order scheme
}

TEST_P(FixedStep, SpringsAloneKeepTheEnergy) {
  const auto o = fixed_step_collision(column(5, 1.0, 0.0), GetParam(), 1.0 / 500);
  double energy = 0.0;
  for (const double v : o.velocity) energy += v * v / 5.0;
  // Each opening and closing is missed by up to a step: (omega dt)^2 of a bead's energy.
  EXPECT_NEAR(energy, 1.0, 1e-4);
}

TEST_P(FixedStep, FinalVelocitiesAreOrdered) {
  for (const double sigma : {0.0, 0.1, 3.0}) {
    const auto o = fixed_step_collision(column(10, 0.8, sigma), GetParam(), 0.01, {.settle = 0.0});
    ASSERT_EQ(o.end, End::separated);
    EXPECT_GE(o.velocity[0], 0.0);
    for (std::size_t k = 1; k < 10; ++k) EXPECT_GE(o.velocity[k], o.velocity[k - 1] - 1e-15);
  }
}

TEST_P(FixedStep, GivesUpAtTheStepLimit) {
  const auto o = fixed_step_collision(column(10, 0.9, 1.0), GetParam(), 0.01, {.work_limit = 10 * 200});
  EXPECT_EQ(o.status, Status::event_limit);
  EXPECT_EQ(o.end, End::none);
}

TEST_P(FixedStep, SaysUnstableWhereTheStepIsTooLong) {
  const auto o = fixed_step_collision(column(10, 1e-6, 0.0), GetParam(), 0.25);
  EXPECT_EQ(o.status, Status::unstable);
  Parameters p;
  p.epsilon = 1e-6;
  p.integrator = GetParam();
  p.steps_per_tc = 4.0;
  const SimulationResult c = simulate_fixed_step(p);
  EXPECT_EQ(c.status, Status::unstable);
  EXPECT_TRUE(std::isnan(c.eps_eff));
}

TEST(Gear5Scheme, IsUnstableUnderStrongDamping) {
  // Stable for about 2 zeta omega dt < 0.16; here 2 zeta omega dt = 4 L dt = 0.31.
  const auto o = fixed_step_collision(column(10, 0.02, 0.0), Integrator::gear5, 1.0 / 50);
  EXPECT_EQ(o.status, Status::unstable);
  const auto shorter = fixed_step_collision(column(10, 0.02, 0.0), Integrator::gear5, 1.0 / 200);
  EXPECT_EQ(shorter.status, Status::ok);
}

TEST(FixedStepCollision, RefusesTheExactIntegrator) {
  EXPECT_THROW(fixed_step_collision(column(1, 0.9, 0.0), Integrator::exact, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace sigmasweep
