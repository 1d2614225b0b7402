#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <random>

#include "assembly/energies.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/fixed_step/column/collision.hpp"
#include "support/parameters.hpp"
#include "support/reference_values.hpp"

/// The schemes of fixed step against the reference values.
namespace sigmasweep {
namespace {

constexpr unsigned seed = 5150;

const reference::Soft* find(std::int64_t N, double epsilon, double sigma) {
  for (const reference::Soft& r : reference::soft)
    if (r.N == N && r.epsilon == epsilon && r.sigma == sigma) return &r;
  return nullptr;
}

Parameters of(const reference::Soft& r, Integrator integrator, double steps_per_tc) {
  return soft_column(
      {.sigma = r.sigma, .epsilon = r.epsilon, .steps_per_tc = steps_per_tc, .N = r.N, .integrator = integrator});
}

class FixedStepConvergence : public testing::TestWithParam<Integrator> {
 protected:
  /// Root mean square of the errors at `steps` to 1.5 `steps` per tc, at random: a grid aligned with tc would show
  /// false orders, since the error depends on where within a step a contact opens and closes.
  double error(const reference::Soft& r, double steps) {
    std::uniform_real_distribution<double> uniform(steps, 1.5 * steps);
    double sum = 0.0;
    constexpr int runs = 12;
    for (int i = 0; i < runs; ++i) {
      const Column<double> column = reduced_column<double>(of(r, GetParam(), 2.0));
      const auto o = fixed_step_collision(column, GetParam(), 1.0 / uniform(random_));
      const double e = energies<double>(o.velocity, 1.0).eps_eff - r.eps_eff;
      sum += o.status == Status::ok ? e * e : NAN;
    }
    return std::sqrt(sum / runs);
  }

 private:
  std::mt19937_64 random_{seed};
};

INSTANTIATE_TEST_SUITE_P(Schemes, FixedStepConvergence,
                         testing::Values(Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog),
                         [](const auto& scheme) { return std::string(name_of(scheme.param)); });

TEST_P(FixedStepConvergence, IsOfFirstOrder) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  for (const double sigma : {0.01, 1.0, 3.0, 10.0}) {
    const reference::Soft* r = find(10, 0.9, sigma);
    ASSERT_NE(r, nullptr);
    const double coarse = error(*r, 40), fine = error(*r, 1280);
    // 32 times shorter steps: 32 times smaller for order one, sqrt(32) = 5.7 for order one half. At least order 0.7.
    EXPECT_LT(fine, coarse / 11.0) << sigma;
    // Worst single contact at tc/50: 3.6e-3; the errors of a column's contacts partly cancel.
    EXPECT_LT(coarse, 5e-3) << sigma;
    EXPECT_LT(fine, 1e-4) << sigma;
    EXPECT_GT(fine, 1e-9) << sigma;  // better than these schemes can be: something is compared with itself
  }
}

TEST_P(FixedStepConvergence, MeetsTheReferenceOfEveryWellConditionedColumn) {
  for (const reference::Soft& r : reference::soft) {
    if (!r.well_conditioned || r.N > 20 || r.epsilon < 0.3) continue;  // stronger damping needs shorter steps
    SCOPED_TRACE(testing::Message() << "N=" << r.N << " eps=" << r.epsilon << " sigma=" << r.sigma);
    const SimulationResult c = simulate(of(r, GetParam(), 1017.3));
    ASSERT_EQ(c.status, Status::ok);
    // First order: a twentieth of the error at tc/50, which is below 2e-2 for each of these.
    EXPECT_NEAR(c.eps_eff, r.eps_eff, 1e-3);
    EXPECT_NEAR(c.t_k, r.t_k * 1e-5, 2e-3 * r.t_k * 1e-5);  // tc = 1e-5 s
    // The error that the row claims is the true one, to the digits of the reference.
    EXPECT_NEAR(c.eps_eff_error, std::fabs(c.eps_eff - r.eps_eff), 1e-9);
  }
}

TEST_P(FixedStepConvergence, IsStableAtAHundredStepsAContact) {
  for (const std::int64_t N : {1, 2, 10, 50})
    for (const double sigma : {0.0, 0.1, 1.0, 100.0}) {
      Parameters p;
      p.N = N;
      p.sigma = sigma;
      p.integrator = GetParam();
      p.steps_per_tc = 100.0;
      const SimulationResult c = simulate(p);
      EXPECT_EQ(c.status, Status::ok) << N << " " << sigma;
      EXPECT_LE(c.eps_eff, 1.0);
      EXPECT_LE(c.eps_eff_error, N < 50 ? 1e-2 : 1.0) << N << " " << sigma;  // N = 50: chaotic for large sigma
    }
}

TEST_P(FixedStepConvergence, TheMatchedWallHasTheRestitutionOfAPair) {
  Parameters p;
  p.N = 1;
  p.epsilon = 0.7;
  p.wall = Wall::matched;
  p.integrator = GetParam();
  p.steps_per_tc = 2000.0;
  const SimulationResult c = simulate(p);
  EXPECT_NEAR(c.eps_eff, 0.7, 5e-4);      // first order
  EXPECT_NEAR(c.t_k, p.tc, 1e-3 * p.tc);  // and the contact time of one
}

/// Columns whose beads touch at the start, at tc/100. The values are of an independent program, which steps positions
/// and velocities instead of overlaps; both round, and 12 digits are known.
TEST(VelocityVerlet, BothKindsTakeTheStepsOfAnIndependentProgram) {
  struct Stepped {
    std::int64_t N;
    double epsilon, verlet, leapfrog;
  };
  for (const Stepped& s : {Stepped{1, 0.9, 0.928634218383, 0.928594839328},   //
                           Stepped{5, 0.9, 0.959330876583, 0.959310031587},   //
                           Stepped{10, 0.9, 0.966711552134, 0.966724307110},  //
                           Stepped{2, 0.5, 0.724470177080, 0.723995627370},   //
                           Stepped{5, 0.5, 0.823468603855, 0.823358064152}}) {
    SCOPED_TRACE(testing::Message() << "N " << s.N << " epsilon " << s.epsilon);
    Parameters p = soft_column({.epsilon = s.epsilon, .steps_per_tc = 100.0, .N = s.N});
    p.integrator = Integrator::verlet;
    EXPECT_NEAR(simulate(p).eps_eff, s.verlet, 2e-12);
    p.integrator = Integrator::leapfrog;
    EXPECT_NEAR(simulate(p).eps_eff, s.leapfrog, 2e-12);
  }
}

class WithoutDamping : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Symplectic, WithoutDamping, testing::Values(Integrator::verlet, Integrator::leapfrog),
                         [](const auto& scheme) { return std::string(name_of(scheme.param)); });

TEST_P(WithoutDamping, ConservesEnergy) {
  for (const double sigma : {0.0, 0.5, 7.0}) {
    Parameters p;
    p.epsilon = 1.0;
    p.sigma = sigma;
    p.integrator = GetParam();
    p.steps_per_tc = 500.0;
    // (omega dt)^2 = 8e-5 of an energy at each of the switches.
    EXPECT_NEAR(simulate(p).eps_eff, 1.0, 1e-4) << sigma;
  }
}

}  // namespace
}  // namespace sigmasweep
