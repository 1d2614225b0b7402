#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/fixed_step/collision.hpp"
#include "support/parameters.hpp"

/// Schemes of fixed step that choose the step by a tolerance.
namespace sigmasweep {
namespace {

class FixedStepTolerance : public testing::TestWithParam<Integrator> {};

INSTANTIATE_TEST_SUITE_P(Schemes, FixedStepTolerance,
                         testing::Values(Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog),
                         [](const auto& scheme) { return std::string(name_of(scheme.param)); });

Parameters tuple(std::int64_t N, double sigma, double eps) {
  return soft_column({.sigma = sigma, .epsilon = eps, .steps_per_tc = 0.0, .N = N});
}

/// In quadruple precision, settled far below every tolerance here.
double reference(const Parameters& p) {
  const auto column = reduced_column<Quad>(p);
  const auto outcome = exact_collision<Quad>(column, {.settle = 1e-15});
  EXPECT_EQ(outcome.status, Status::ok);
  return static_cast<double>(energies<Quad>(std::span<const Quad>(outcome.velocity), Quad(1)).eps_eff);
}

TEST_P(FixedStepTolerance, IsKept) {
  for (const std::int64_t N : {1, 5, 10})
    for (const double sigma : {0.0, 0.3, 3.0})
      for (const double eps : {0.1, 0.6, 0.9, 1.0}) {
        Parameters p = tuple(N, sigma, eps);
        const double exact = reference(p);
        for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
          p.integrator = GetParam();
          p.tolerance = tolerance;
          const SimulationResult c = simulate(p);
          SCOPED_TRACE(testing::Message() << "N=" << N << " sigma=" << sigma << " eps=" << eps << " " << tolerance);
          // The claim holds whether or not the tolerance could be kept; 1e-13: what the reference settles at.
          EXPECT_NEAR(c.eps_eff, exact, c.eps_eff_error + 1e-13);
          EXPECT_TRUE(c.status == Status::ok || (tolerance <= 1e-6 && c.status == Status::tolerance_missed))
              << name_of(c.status) << " " << c.eps_eff_error;
          if (c.status == Status::ok) {
            EXPECT_LE(std::fabs(c.eps_eff - exact), tolerance);
            EXPECT_LE(c.eps_eff_error, tolerance);
          } else {
            EXPECT_GT(c.eps_eff_error, tolerance);
          }
        }
      }
}

TEST_P(FixedStepTolerance, OtherLawsKeepItToo) {
  for (const Law law : {Law::hertz, Law::hertz_kuwabara_kono}) {
    Parameters p = tuple(5, 0.1, 0.85);
    p.law = law;
    p.tolerance = 1e-4;
    const SimulationResult exact = simulate(p);
    p.integrator = GetParam();
    const SimulationResult c = simulate(p);
    EXPECT_EQ(c.status, Status::ok);
    EXPECT_NEAR(c.eps_eff, exact.eps_eff, p.tolerance + exact.eps_eff_error);
  }
}

TEST_P(FixedStepTolerance, TheStepTakenGivesTheSameAgain) {
  Parameters p = tuple(5, 0.3, 0.8);
  p.integrator = GetParam();
  p.tolerance = 1e-3;
  const SimulationResult chosen = simulate(p);
  EXPECT_EQ(chosen.steps_used, steps_taken(p));
  EXPECT_GE(chosen.steps_used, 20.0);
  p.steps_per_tc = chosen.steps_used;
  const SimulationResult given = simulate(p);
  EXPECT_EQ(given.steps_used, chosen.steps_used);
  EXPECT_EQ(chosen.eps_eff, given.eps_eff);
  EXPECT_EQ(chosen.contacts, given.contacts);
}

TEST_P(FixedStepTolerance, WhatCannotBeKeptIsMissedWithTheErrorFound) {
  Parameters p = tuple(10, 3.0, 0.9);
  p.integrator = GetParam();
  p.tolerance = 1e-12;
  const SimulationResult c = simulate(p);
  EXPECT_EQ(c.status, Status::tolerance_missed);
  EXPECT_GT(c.eps_eff_error, 1e-12);
  EXPECT_LT(c.eps_eff_error, 1e-4);
}

}  // namespace
}  // namespace sigmasweep
