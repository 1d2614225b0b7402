// Laws that are not linear: against independent integrations, closed formulas, the linear solver and itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "assembly/energies.hpp"
#include "sigmasweep/contact/pair_collision.hpp"
#include "sigmasweep/contact/theory.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "support/error_bars.hpp"
#include "support/parameters.hpp"
#include "support/random.hpp"

namespace {

using namespace sigmasweep;

/// Fig. 3's column: v0 = 0.05 m/s, s0 = 0.
Parameters fig3(Law law, double K_over_m, double D_n, std::int64_t N) {
  Parameters p;
  p.law = law;
  p.v0 = 0.05;
  p.K_over_m = K_over_m;
  p.D_n = D_n;
  p.N = N;
  return completed(p);
}

Parameters touching_pair(Law law, double beta, double gamma, double epsilon) {
  // The bead moves against the wall as two beads against each other.
  return soft_column({.v0 = 1.0,
                      .tc = 1.0,
                      .epsilon = epsilon,
                      .beta = beta,
                      .gamma = gamma,
                      .N = 1,
                      .wall = Wall::matched,
                      .law = law});
}

struct Reference {
  std::int64_t N;
  double eps_eff, uncertainty;
};

void expect(const Reference& r, const Parameters& p) {
  const SimulationResult c = simulate(p);
  SCOPED_TRACE(testing::Message() << "N = " << r.N << ", K_over_m = " << p.K_over_m << ", D_n = " << p.D_n);
  EXPECT_EQ(c.status, Status::ok);
  // The reference's own uncertainty is the larger part.
  EXPECT_NEAR(c.eps_eff, r.eps_eff, r.uncertainty + c.eps_eff_error);
}

// Runge-Kutta 5(4) at 1e-12, its uncertainty by comparison with 1e-10; K and D_n over the bead mass there.
TEST(Nonlinear, AgreesWithAnIndependentIntegrationOfHertz) {
  for (const Reference& r : {Reference{1, 0.924199893084, 8e-9},
                             {2, 0.932756002156, 3e-9},
                             {5, 0.935321493987, 2e-9},
                             {10, 0.927916594539, 1e-9},
                             {20, 0.912776719987, 2e-9},
                             {50, 0.897248356162, 2e-10},
                             {100, 0.894818393175, 3e-10},
                             {200, 0.894294629277, 2e-10}})
    expect(r, fig3(Law::hertz, 4e12, 2e3, r.N));
}

// The same with both over the reduced mass.
TEST(Nonlinear, AgreesWithAnIndependentIntegrationOfWeakerHertz) {
  for (const Reference& r : {Reference{1, 0.949462533243, 2e-8},
                             {2, 0.954287329125, 3e-9},
                             {5, 0.954218339474, 6e-9},
                             {10, 0.945477917148, 8e-10},
                             {20, 0.927650467246, 7e-10},
                             {50, 0.903374294488, 7e-10},
                             {100, 0.896946617058, 4e-10},
                             {200, 0.895355986756, 2e-10}})
    expect(r, fig3(Law::hertz, 2e12, 1e3, r.N));
}

TEST(Nonlinear, TheLinearLawByItsConstantsAgreesToo) {
  for (const Reference& r : {Reference{1, 0.924265096433, 5e-10},
                             {2, 0.942003112172, 6e-10},
                             {5, 0.957156306910, 3e-9},
                             {10, 0.965121738232, 2e-9},
                             {20, 0.972136095487, 4e-10},
                             {100, 0.984846612989, 2e-10}})
    expect(r, fig3(Law::hooke, 2e9, 0.5 * 3.17e3, r.N));
  for (const Reference& r :
       {Reference{1, 0.945841378575, 8e-9}, {10, 0.973906434625, 2e-9}, {50, 0.984365502578, 4e-10}})
    expect(r, fig3(Law::hooke, 4e9, 0.5 * 3.17e3, r.N));
}

// Fig. 3 as the paper means it (K/m over the reduced mass), four digits of an independent program.
TEST(Nonlinear, Fig3) {
  struct Curve {
    Law law;
    double K_over_m, D_n;
    std::vector<double> eps_eff;  // N = 1, 2, 5, ..., 200
  };
  const std::vector<Curve> curves{
      {Law::hooke, 2e9, 3.17e3, {.8541, .8912, .9229, .9401, .9541, .9686, .9769, .9832}},
      {Law::hertz, 2e12, 2e3, {.9010, .9136, .9196, .9148, .9034, .8941, .8933, .8935}},
      {Law::hertz_kuwabara_kono, 2e12, 1e5, {.9960, .9960, .9951, .9924, .9863, .9693, .9480, .9229}}};
  const std::vector<std::int64_t> beads{1, 2, 5, 10, 20, 50, 100, 200};
  for (const Curve& curve : curves)
    for (std::size_t i = 0; i < beads.size(); ++i) {
      const SimulationResult c = simulate(fig3(curve.law, curve.K_over_m, curve.D_n, beads[i]));
      EXPECT_EQ(c.status, Status::ok);
      EXPECT_NEAR(c.eps_eff, curve.eps_eff[i], 0.51e-4) << "N = " << beads[i];
    }
}

// One bead at a matched wall is a pair: the scene's own solution of that, with another scheme.
TEST(Nonlinear, ASingleBeadIsAPairCollision) {
  struct Case {
    Law law;
    double beta, gamma;
  };
  for (const Case& x : {Case{Law::hertz, 0, 0},
                        {Law::hertz_kuwabara_kono, 0, 0},
                        {Law::taguchi, 0, 0},
                        {Law::power, 0.0, 0.2},
                        {Law::power, 0.3, 0.7},
                        {Law::power, 1.0, 0.0},
                        {Law::power, 1.5, 1.5}})
    for (const double epsilon : {0.99, 0.9, 0.6, 0.2}) {
      const Parameters p = touching_pair(x.law, x.beta, x.gamma, epsilon);
      const Exponents e = exponents(p);
      const double k = theory::stiffness(e, 1.0, 1.0);
      const PairCollision pair = collide({e, k, damping(e, k, 1.0, epsilon)}, 1.0);
      const SimulationResult c = simulate(p);
      SCOPED_TRACE(testing::Message() << "beta " << e.beta << " gamma " << e.gamma << " epsilon " << epsilon);
      EXPECT_EQ(c.status, Status::ok);
      EXPECT_NEAR(c.eps_eff, epsilon, c.eps_eff_error + 1e-13);  // what damping() leaves
      EXPECT_NEAR(c.t_k, pair.duration, 1e-10 * pair.duration);  // ten local accuracies over a steep end
      EXPECT_NEAR(c.x_max, pair.x_max, 1e-11);
    }
}

TEST(Nonlinear, LossesNothingWithoutDamping) {
  for (const double sigma : {0.0, 0.2, 5.0})
    for (const Law law : {Law::hertz, Law::taguchi}) {
      Parameters p;
      p.law = law;
      p.epsilon = 1.0;
      p.sigma = sigma;
      p.N = 12;
      const SimulationResult c = simulate(completed(p));
      EXPECT_EQ(c.status, Status::ok);
      EXPECT_NEAR(c.eps_eff, 1.0, c.eps_eff_error);
    }
}

// The exponents (0, 0) through the solver for the others, against the linear solver.
TEST(Nonlinear, TheLinearLawIsSolvedAsWell) {
  for (const double sigma : {0.0, 0.1, 1.0, 4.0}) {
    Parameters p;
    p.sigma = sigma;
    p.N = 7;
    p.epsilon = 0.8;
    const auto column = reduced_column<double>(completed(p));
    const auto energy = [&](const Outcome<double>& o) { return energies<double>(o.velocity, 1.0).eps_eff; };
    EXPECT_NEAR(energy(nonlinear_collision(column, 1e-14)), energy(exact_collision(column)), 1e-12) << sigma;
  }
}

// Only sigma, N, epsilon and the exponents count when the law is given by (tc, epsilon).
TEST(Nonlinear, ScalesWithSigma) {
  Parameters p;
  p.law = Law::hertz_kuwabara_kono;
  p.sigma = 0.37;
  p.N = 9;
  p.v0 = p.tc = 1.0;
  const SimulationResult a = simulate(completed(p));
  p.v0 = 3e-9;
  p.tc = 7e4;
  const SimulationResult b = simulate(completed(p));
  EXPECT_EQ(a.eps_eff, b.eps_eff);
  EXPECT_NEAR(b.t_k, a.t_k * p.tc, 1e-15 * b.t_k);
}

TEST(Nonlinear, ErrorBarHoldsForRandomTuples) {
  Random uniform(7041994);
  ErrorBars bars;
  for (int i = 0; i < 120; ++i) {
    Parameters p;
    p.law = static_cast<Law>(1 + static_cast<int>(4.0 * uniform()));
    p.beta = uniform();
    p.gamma = uniform();
    p.N = 1 + static_cast<std::int64_t>(14.0 * std::pow(uniform(), 2));
    p.epsilon = 0.4 + 0.6 * uniform();
    p.sigma = i % 5 == 0 ? 0.0 : std::pow(10.0, -3.0 + 4.0 * uniform());
    p = completed(p);
    const SimulationResult c = simulate(p);
    if (c.status == Status::tolerance_missed) continue;  // chaotic, and says so
    ASSERT_EQ(c.status, Status::ok);
    const auto column = reduced_column<long double>(p);
    const Outcome<long double> finer = nonlinear_collision(column, 1e-16, {.settle = 1e-14});
    const long double eps_eff = energies<long double>(finer.velocity, 1.0L).eps_eff;
    const double error = std::fabs(static_cast<double>(eps_eff) - c.eps_eff);
    bars.see(error, c.eps_eff_error);
    EXPECT_LE(error, 10.0 * c.eps_eff_error) << "law " << int(p.law) << " N " << p.N << " sigma " << p.sigma;
  }
  bars.expect_true(110);
}

/// Contact 2 opens 3e-5 tc after contact 1 has closed: a step that ends there is a part of one whose error estimate did
/// not see the kink, and has its own.
TEST(Nonlinear, ErrorBarHoldsWhereAStepEndsAtAKink) {
  Parameters p = soft_column({.sigma = 1.081180751076608, .epsilon = 0.9, .N = 3, .law = Law::hertz_kuwabara_kono});
  p.tolerance = 1e-12;
  const SimulationResult fine = simulate(p);
  for (const double tolerance : {1e-8, 1e-9, 1e-10}) {
    p.tolerance = tolerance;
    const SimulationResult c = simulate(p);
    EXPECT_NEAR(c.eps_eff, fine.eps_eff, c.eps_eff_error + fine.eps_eff_error) << tolerance;
    EXPECT_LE(c.eps_eff_error, tolerance);
  }
}

TEST(Nonlinear, MeetsTheTolerance) {
  for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-12}) {
    Parameters p = fig3(Law::hertz_kuwabara_kono, 2e12, 1e5, 20);
    p.tolerance = tolerance;
    const SimulationResult c = simulate(p);
    EXPECT_EQ(c.status, Status::ok);
    EXPECT_LE(c.eps_eff_error, tolerance);
    EXPECT_NEAR(c.eps_eff, 0.9862550888036, tolerance);  // accuracies 1e-13 and 1e-14 agree to these digits
  }
}

}  // namespace
