#include <gtest/gtest.h>

#include <cmath>

#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"
#include "support/reference_values.hpp"

/// The touching columns (s0 = 0) of the paper's Fig. 2(b), 2(c) and Sec. IV A, as the specs in sweeps/ have them.
/// Numbers are those of independent programs, to the digits given; the paper's own where they are called so.
namespace sigmasweep {
namespace {

constexpr double v0 = 0.05, tc = 2e-5;  // m/s, s: the caption of Fig. 2(b)

SimulationResult touching(std::int64_t N, double epsilon, double speed = v0, double contact_time = tc) {
  return simulate(completed({.v0 = speed, .tc = contact_time, .s0 = 0.0, .epsilon = epsilon, .N = N}));
}

double loss(std::int64_t N, double epsilon) { return 1.0 - touching(N, epsilon).eps_eff; }

double slope(std::int64_t from, std::int64_t to, double epsilon) {
  return std::log(loss(to, epsilon) / loss(from, epsilon)) /
         std::log(static_cast<double>(to) / static_cast<double>(from));
}

/// Half a unit of the last of three digits after the point.
constexpr double three_digits = 0.5e-3;

}  // namespace

TEST(PaperFigures, TouchingColumnsAreThoseOfTheReferences) {
  int checked = 0;
  for (const reference::Soft& r : reference::soft) {
    if (r.sigma != 0.0 || !r.well_conditioned) continue;
    SCOPED_TRACE(testing::Message() << "N=" << r.N << " eps=" << r.epsilon);
    const SimulationResult c = touching(r.N, r.epsilon);
    EXPECT_EQ(c.status, Status::ok);
    EXPECT_NEAR(c.eps_eff, r.eps_eff, c.eps_eff_error + r.uncertainty);
    EXPECT_LE(c.eps_eff_error, 1e-10);
    // E_r = E_f - E_cm: what the run stopped short of (at 1e-13 of eps_eff) and twice the error of eps_eff.
    EXPECT_NEAR(c.Er_Ef, r.Er_Ef, 2.0 * c.eps_eff_error / c.eps_eff + 1e-12);
    EXPECT_NEAR(c.t_k, r.t_k * tc, 1e-11 * r.t_k * tc);  // tc itself has 16 digits; events are found to about 1e-15
    ++checked;
  }
  EXPECT_GT(checked, 25);
}

TEST(PaperFigures, Fig2bSlopesBetweenFiftyAndAHundredBeads) {
  EXPECT_NEAR(slope(50, 100, 0.6), -0.474, three_digits);    // the paper's line has -0.5
  EXPECT_NEAR(slope(50, 100, 0.975), -0.297, three_digits);  // the paper's line has -0.315
}

TEST(PaperFigures, Fig2bLossFallsWithLengthAndWithRestitution) {
  double above = 1.0;
  for (const double epsilon : {0.6, 0.8, 0.9, 0.95, 0.975}) {  // "from top to bottom for each N value"
    double before = 1.0;
    for (const std::int64_t N : {1, 2, 5, 10, 20, 50, 100}) {
      const double now = loss(N, epsilon);
      EXPECT_LT(now, before) << N << " " << epsilon;
      EXPECT_GT(now, 0.0);
      before = now;
    }
    EXPECT_LT(before, above);
    above = before;
  }
}

TEST(PaperFigures, Fig2cRelativeEnergyOfTenBeads) {
  EXPECT_NEAR(touching(10, 0.9).Er_Ef, 0.0338592, 0.5e-7);
  EXPECT_NEAR(touching(10, 0.9).Er_Ef, 0.035, 0.0015);          // the paper's, 3.4 % off
  EXPECT_GT(touching(10, 0.6).Er_Ef, touching(10, 0.9).Er_Ef);  // "even in the case of very high dissipation"
}

TEST(PaperFigures, ContactTimeIsAboutNTimesThatOfAPair) {
  const std::pair<std::int64_t, double> expected[] = {{1, 1.414},  {2, 1.183},  {5, 1.021},  {10, 0.964},
                                                      {20, 0.934}, {50, 0.915}, {100, 0.907}};
  for (const auto& [N, ratio] : expected)
    for (const double contact_time : {2e-6, 2e-5, 2e-3})
      EXPECT_NEAR(touching(N, 0.9, v0, contact_time).t_k / (static_cast<double>(N) * contact_time), ratio, three_digits)
          << N << " " << contact_time;
}

TEST(PaperFigures, RelativeEnergyGoesWithTheSquareOfTheSpeed) {
  const double at_one = touching(10, 0.9, 1.0).Er_E0;
  for (const double speed : {1e-6, 1e-3, 0.05, 100.0})
    EXPECT_EQ(touching(10, 0.9, speed).Er_E0, at_one);  // to the bit: the speed is the unit
}

TEST(PaperFigures, LossIsProportionalToThatOfAPairWhereBothAreSmall) {
  for (const double epsilon : {0.9999, 0.99999}) EXPECT_NEAR(loss(10, epsilon) / (1.0 - epsilon), 0.398, three_digits);
}

}  // namespace sigmasweep
