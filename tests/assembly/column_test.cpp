#include "assembly/column.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/quad.hpp"
#include "sigmasweep/contact/calibration.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

TEST(Column, TheSpringsOfThePairAndOfBothWalls) {
  Parameters p;
  p.epsilon = 0.8;
  const Column<double> paper = reduced_column<double>(p);
  EXPECT_EQ(paper.K_wall, paper.K);
  EXPECT_EQ(paper.C_wall, paper.C);
  // A pair's overlap obeys x'' + 2 C x' + 2 K x = 0, the wall's x'' + C x' + K x = 0.
  EXPECT_NEAR(contact_time(Oscillator<double>{paper.C, 2 * paper.K}), 1.0, 1e-14);
  EXPECT_NEAR(restitution(Oscillator<double>{paper.C, 2 * paper.K}), 0.8, 1e-14);
  EXPECT_NEAR(restitution(Oscillator<double>{paper.C_wall / 2, paper.K_wall}), 0.854201911780941295, 1e-14);
  EXPECT_NEAR(paper.eps_wall, 0.854201911780941295, 1e-15);

  p.wall = Wall::matched;
  const Column<double> matched = reduced_column<double>(p);
  EXPECT_EQ(matched.eps_wall, 0.8);
  EXPECT_NEAR(contact_time(Oscillator<double>{matched.C_wall / 2, matched.K_wall}), 1.0, 1e-14);
  EXPECT_NEAR(restitution(Oscillator<double>{matched.C_wall / 2, matched.K_wall}), 0.8, 1e-14);
}

TEST(Column, ReducedUnitsKeepOnlySigma) {
  Parameters a{.v0 = 0.1, .tc = 1e-5, .sigma = 0.3};
  Parameters b{.v0 = 7.0, .tc = 3e-3, .sigma = 0.3};
  const auto ca = reduced_column<double>(a), cb = reduced_column<double>(b);
  EXPECT_EQ(ca.gap, 0.3);
  EXPECT_EQ(ca.gap, cb.gap);
  EXPECT_EQ(ca.K, cb.K);
  EXPECT_EQ(ca.C, cb.C);
  EXPECT_EQ(ca.speed, 1.0);
  EXPECT_EQ(ca.tc, 1.0);
}

TEST(Column, SIUnitsAreTheReducedOnesTimesPowersOfTheContactTime) {
  Parameters p{.v0 = 0.2, .tc = 4e-6, .s0 = 1e-7, .epsilon = 0.7};
  p = completed(p);
  const auto si = si_column<double>(p), reduced = reduced_column<double>(p);
  EXPECT_EQ(si.gap, 1e-7);
  EXPECT_EQ(si.speed, 0.2);
  EXPECT_NEAR(si.K * p.tc * p.tc / reduced.K, 1.0, 1e-15 * 4);
  EXPECT_NEAR(si.C * p.tc / reduced.C, 1.0, 1e-15 * 4);
}

TEST(Column, WiderTypesAreComputedInTheWiderType) {
  Parameters p;
  p.epsilon = 0.9;
  // -ln of the double nearest to 0.9, to 33 digits: C in reduced units.
  const Quad L("0.105360515657826276555878211391390");
  using std::abs;
  EXPECT_LT(abs(reduced_column<Quad>(p).C - L), Quad(1e-29));
  EXPECT_LT(std::abs(reduced_column<long double>(p).C - static_cast<long double>(L)), 1e-19L);
}

}  // namespace
}  // namespace sigmasweep
