// The exact integrator against independent programs, closed formulas and conservation laws.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "support/parameters.hpp"
#include "support/reference_values.hpp"

namespace {

using namespace sigmasweep;

Parameters tuple(std::int64_t N, double epsilon, double sigma, double v0 = 0.2, double tc = 1e-5) {
  return soft_column({.v0 = v0, .tc = tc, .sigma = sigma, .epsilon = epsilon, .N = N});
}

class SoftReference : public testing::TestWithParam<reference::Soft> {};

TEST_P(SoftReference, IsReproduced) {
  const reference::Soft& expected = GetParam();
  const Parameters p = tuple(expected.N, expected.epsilon, expected.sigma);
  const SimulationResult c = simulate(p);
  if (!expected.well_conditioned) {
    // The last digits of sigma decide. Whoever claims a result must be within the error bar of it.
    EXPECT_LE(std::abs(c.eps_eff - expected.eps_eff), c.eps_eff_error + 10 * expected.uncertainty);
    return;
  }
  EXPECT_EQ(c.status, Status::ok);
  EXPECT_NEAR(c.eps_eff, expected.eps_eff, 1e-11 + expected.uncertainty);
  EXPECT_LE(std::abs(c.eps_eff - expected.eps_eff), c.eps_eff_error + expected.uncertainty);
  EXPECT_NEAR(c.Er_Ef, expected.Er_Ef, 1e-10);
  EXPECT_NEAR(c.t_k / p.tc, expected.t_k, double(expected.N) * (1e-11 + 1e-14 * expected.sigma));
}

INSTANTIATE_TEST_SUITE_P(Columns, SoftReference, testing::ValuesIn(reference::soft), [](const auto& run) {
  return "row" + std::to_string(run.index) + "_N" + std::to_string(run.param.N);
});

// The numbers of Figs. 2(a) and 1(a).
TEST(ExactColumn, TheNumbersOfThePaper) {
  EXPECT_NEAR(simulate(tuple(10, 0.9, 0.0)).eps_eff, 0.966686739758, 1e-12);
  EXPECT_NEAR(simulate(tuple(10, 0.9, 0.0)).Er_Ef, 0.0338592, 5e-8);
  EXPECT_NEAR(simulate(tuple(10, 0.9, 0.1)).eps_eff, 0.931129144499, 1e-12);
  EXPECT_NEAR(simulate(tuple(10, 0.9, 1.0)).eps_eff, 0.424689077436, 1e-12);
  EXPECT_NEAR(simulate(tuple(10, 0.9, 10.0)).eps_eff, 0.341547467017, 1e-12);
}

TEST(ExactColumn, OneBeadComesBackWithTheWallsRestitution) {
  for (double eps : {1.0, 0.9, 0.6, 0.1, 1e-3, 1e-6}) {
    const double L = -std::log(eps), pi = std::acos(-1.0);
    for (double sigma : {0.0, 1.0, 1e9}) {
      const SimulationResult c = simulate(tuple(1, eps, sigma));
      EXPECT_NEAR(c.eps_eff, std::exp(-pi * L / std::sqrt(2 * pi * pi + L * L)), 1e-15) << eps << " " << sigma;
      EXPECT_NEAR(c.t_k, 1e-5 * pi * std::sqrt(2.0) / std::sqrt(pi * pi + L * L - L * L / 2.0), 1e-19);
      EXPECT_EQ(c.contacts, 1u);
    }
  }
}

TEST(ExactColumn, TheMatchedWallGivesThePairsRestitutionAndContactTime) {
  Parameters p = tuple(1, 0.8, 0.5);
  p.wall = Wall::matched;
  const SimulationResult c = simulate(p);
  EXPECT_NEAR(c.eps_eff, 0.8, 1e-15);
  EXPECT_NEAR(c.t_k, p.tc, 1e-19);
}

// With eps = 1 nothing is lost, whatever the number of contacts.
TEST(ExactColumn, SpringsAloneConserveEnergy) {
  for (std::int64_t N : {1, 2, 3, 10, 30, 100})
    for (double sigma : {0.0, 1e-3, 0.3, 3.0, 1e3}) {
      const SimulationResult c = simulate(tuple(N, 1.0, sigma));
      EXPECT_NEAR(c.eps_eff, 1.0, 1e-13) << N << " " << sigma;  // thousands of contacts of a few roundings each
    }
}

TEST(ExactColumn, WideGapsAreHardSpheres) {
  Parameters p = tuple(10, 0.9, 1e4);
  const SimulationResult soft = simulate(p);
  p.method = Method::ed;
  EXPECT_NEAR(soft.eps_eff, simulate(p).eps_eff, 1e-12);
  EXPECT_EQ(soft.contacts, 100u);
}

// v0, tc and s0 enter only through sigma: to the bit in reduced units, and to rounding in raw SI units.
TEST(ExactColumn, RowsOfEqualSigmaAreEqual) {
  for (double sigma : {0.0, 1e-4, 0.1, 0.7, 1.0, 5.0, 300.0}) {
    const SimulationResult one = simulate(tuple(10, 0.9, sigma, 1.0, 1.0));
    for (double v0 : {14.0, 0.008, 1e-15, 1e3})
      for (double tc : {2.5e-6, 2.2e-3, 1e-12}) {
        const Parameters p = tuple(10, 0.9, sigma, v0, tc);
        EXPECT_EQ(simulate(p).eps_eff, one.eps_eff);
        const auto si = exact_collision(si_column<double>(p));
        EXPECT_NEAR(energies<double>(si.velocity, p.v0).eps_eff, one.eps_eff, 1e-12) << sigma << " " << v0 << " " << tc;
        EXPECT_NEAR(si.t_k, one.t_k * tc, 1e-11 * one.t_k * tc);
      }
  }
}

TEST(ExactColumn, TheLargestOverlapOfOneBeadIsThatOfADampedOscillator) {
  const double eps = 0.7, L = -std::log(eps), pi = std::acos(-1.0);
  const double omega0 = std::sqrt((pi * pi + L * L) / 2.0), mu = L / 2.0, omega = std::sqrt(omega0 * omega0 - mu * mu);
  const double expected = std::exp(-mu / omega * std::atan(omega / mu)) / omega0;
  const Parameters p = tuple(1, eps, 0.0);
  EXPECT_NEAR(simulate(p).x_max / (p.v0 * p.tc), expected, 1e-15);
}

// The largest overlap is read off the solution's polynomials; here it is sampled on a fine grid instead, by RK4 (first
// order at the contacts). In the second column it is reached while the neighbours still push.
TEST(ExactColumn, TheLargestOverlapOfAColumn) {
  for (Parameters p : {tuple(10, 0.9, 0.1), tuple(30, 0.427309, 0.235041)}) {
    const double exact = simulate(p).x_max;
    p.integrator = Integrator::rk4;
    p.steps_per_tc = 20'000;
    EXPECT_NEAR(simulate(p).x_max / exact, 1.0, 1e-5) << p.N;
  }
}

TEST(ExactColumn, RunsToTheEndOrStopsWhereNothingIsLeftToLose) {
  for (double sigma : {0.0, 0.1, 1.0, 10.0}) {
    const auto column = reduced_column<double>(tuple(20, 0.9, sigma));
    RunLimits limits;
    limits.settle = 0.0;
    const auto whole = exact_collision(column, limits);
    EXPECT_EQ(whole.end, End::separated);
    EXPECT_EQ(residual_dissipation<double>(whole.velocity, 1.0), 0.0);
    limits.settle = 1e-6;
    const auto cut = exact_collision(column, limits);
    EXPECT_NEAR(energies<double>(cut.velocity, 1.0).eps_eff, energies<double>(whole.velocity, 1.0).eps_eff, 1e-6);
    EXPECT_LE(cut.contacts, whole.contacts);
  }
}

TEST(ExactColumn, GivesUpAtTheEventLimit) {
  RunLimits limits;
  limits.event_limit = 20;
  EXPECT_EQ(exact_collision(reduced_column<double>(tuple(10, 0.9, 10.0)), limits).status, Status::event_limit);
}

}  // namespace
