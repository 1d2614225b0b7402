// Pairs given by K_over_m and D_n that are critically damped or more: they never come apart of themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/piecewise_linear.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

constexpr double K_over_m = 2e9;  // 1/s^2

/// `damping`: D_n/sqrt(K_over_m), 1 is critical. s0 in units of v0/sqrt(K_over_m).
Parameters tuple(std::int64_t N, double damping, double s0) {
  constexpr double v0 = 0.3;
  const double omega = std::sqrt(K_over_m);
  return soft_column({.v0 = v0, .s0 = s0 * v0 / omega, .K_over_m = K_over_m, .D_n = damping * omega, .N = N});
}

template <class Real>
Real eps_eff_in(const Parameters& p) {
  RunLimits limits;
  limits.settle = 1e-16;
  const auto column = reduced_column<Real>(p);
  const auto outcome = exact_collision(column, limits);
  EXPECT_EQ(outcome.status, Status::ok);
  return energies<Real>(outcome.velocity, Real(1), column.mass).eps_eff;
}

TEST(Overdamped, HasNoRestitutionButAUnitOfTime) {
  for (const double damping : {1.0, 1.5, 1e6}) {
    const Parameters p = tuple(3, damping, 1.0);
    EXPECT_EQ(p.epsilon, 0.0);
    EXPECT_DOUBLE_EQ(p.tc, std::numbers::pi / std::sqrt(K_over_m));
    EXPECT_EQ(why_invalid(p), "");
  }
}

TEST(Overdamped, HardSpheresRefuse) {
  Parameters p = tuple(3, 1.5, 1.0);
  p.method = Method::ed;
  EXPECT_NE(why_invalid(p).find("too damped to come apart"), std::string::npos);
  EXPECT_EQ(simulate(p).status, Status::failed);
  Parameters without_spring;
  without_spring.epsilon = 0.0;
  EXPECT_EQ(why_invalid(without_spring).rfind("epsilon = 0 ", 0), 0u);
}

// The bead moves with its whole mass at the wall: x'' + D_n x' + K_over_m/2 x = 0, which oscillates up to
// D_n = sqrt(2 K_over_m), where pairs have long ceased to. 1e-12: roundings of a cosine close to its zero.
TEST(Overdamped, OneBeadComesBackFromTheWall) {
  for (const double damping : {1.0, 1.2, 1.4}) {
    const Parameters p = tuple(1, damping, 0.5);
    const double mu = p.D_n / 2, omega = std::sqrt(K_over_m / 2 - mu * mu);
    const SimulationResult c = simulate(p);
    EXPECT_EQ(c.status, Status::ok);
    EXPECT_EQ(c.end, End::separated);
    EXPECT_NEAR(c.eps_eff, std::exp(-mu * std::numbers::pi / omega), 1e-12) << damping;
    EXPECT_NEAR(c.t_k * omega, std::numbers::pi, 1e-11) << damping;
    EXPECT_NEAR(c.x_max, p.v0 * std::exp(-mu * std::atan2(omega, mu) / omega) / std::sqrt(K_over_m / 2),
                1e-13 * p.v0 * p.tc);
  }
  EXPECT_NEAR(simulate(tuple(1, 1.0, 0.0)).eps_eff, std::exp(-std::numbers::pi), 1e-12);
}

TEST(Overdamped, OneBeadStaysAtTheWall) {
  for (const double damping : {1.5, 3.0, 10.0}) {
    const Parameters p = tuple(1, damping, 0.5);
    const SimulationResult c = simulate(p);
    EXPECT_EQ(c.status, Status::ok) << damping;
    EXPECT_LE(c.eps_eff, c.eps_eff_error) << damping;  // 0
    EXPECT_LE(c.eps_eff_error, p.tolerance) << damping;
    // x = v0 (e^(-s t) - e^(-r t))/(r - s), largest where its rate is 0.
    const double mu = p.D_n / 2, root = std::sqrt(mu * mu - K_over_m / 2), r = mu + root, s = K_over_m / 2 / r;
    const double turn = std::log(r / s) / (r - s);
    EXPECT_NEAR(c.x_max, p.v0 * (std::exp(-s * turn) - std::exp(-r * turn)) / (r - s), 1e-12 * c.x_max) << damping;
  }
}

// Another method, Eigen's matrix exponential; it stops when everything is slower than 1e-14.
TEST(Overdamped, MovesAsTheMatrixExponentialSays) {
  for (const std::int64_t N : {2, 3, 4})
    for (const double damping : {1.0, 1.3, 3.0})
      for (const double s0 : {0.0, 0.4, 5.0}) {
        const Parameters p = tuple(N, damping, s0);
        const auto column = reduced_column<double>(p);
        const auto expected = piecewise_linear::Solver(column, 0.02 / damping).run();
        const auto outcome = exact_collision(column);
        ASSERT_EQ(outcome.status, Status::ok);
        for (std::size_t k = 0; k < column.contacts(); ++k)
          EXPECT_NEAR(outcome.velocity[k], expected.velocity[k], 1e-11)
              << "N " << N << " damping " << damping << " s0 " << s0 << " bead " << k;
      }
}

TEST(Overdamped, TheErrorBarHolds) {
  for (const std::int64_t N : {1, 2, 3, 6, 10})
    for (const double damping : {0.9, 0.993, 0.997, 1.0 - 1e-9, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.3, 4.0})
      for (const double s0 : {0.0, 0.3, 0.4, 0.5, 10.0}) {
        const Parameters p = tuple(N, damping, s0);
        const SimulationResult c = simulate(p);
        SCOPED_TRACE(testing::Message() << "N " << N << " damping " << damping << " s0 " << s0);
        ASSERT_EQ(c.status, Status::ok);
        const long double wide = eps_eff_in<long double>(p);
        EXPECT_LE(std::fabs(double(wide - (long double)(c.eps_eff))), c.eps_eff_error);
      }
}

// Nothing happens at the critical damping: tc and epsilon have their singularity there, the motion has none.
TEST(Overdamped, IsReachedContinuously) {
  for (const std::int64_t N : {1, 3, 8}) {
    const double critical = simulate(tuple(N, 1.0, 0.2)).eps_eff;
    for (const double change : {-1e-6, -1e-9, 1e-9, 1e-6})
      EXPECT_NEAR(simulate(tuple(N, 1.0 + change, 0.2)).eps_eff, critical, 20.0 * std::fabs(change) + 1e-12) << N;
  }
}

TEST(Overdamped, FixedStepsGetThereToo) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::rk4}) {
    Parameters p = tuple(5, 1.5, 0.2);
    const double exact = simulate(p).eps_eff;
    p.integrator = integrator;
    p.steps_per_tc = 4000;
    const SimulationResult c = simulate(p);
    EXPECT_EQ(c.status, Status::ok);
    EXPECT_NEAR(c.eps_eff, exact, 3e-3);  // first order, as everywhere
    EXPECT_NEAR(c.eps_eff, exact, c.eps_eff_error);
  }
}

// Hertz's law, against a scheme of fixed step: first order.
TEST(Overdamped, OtherLawsStickAsWell) {
  Parameters p{.v0 = 0.05, .K_over_m = 2e12, .D_n = 4e4, .N = 3};
  p.law = Law::hertz;
  p = complete(p, GapParameter::s0);
  ASSERT_EQ(p.epsilon, 0.0);
  ASSERT_EQ(why_invalid(p), "");
  const SimulationResult c = simulate(p);
  EXPECT_EQ(c.status, Status::ok);
  p.integrator = Integrator::rk4;
  p.steps_per_tc = 4000;
  EXPECT_NEAR(simulate(p).eps_eff, c.eps_eff, 3e-3);
}

}  // namespace
