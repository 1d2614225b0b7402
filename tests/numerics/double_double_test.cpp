// Sums of two doubles against 113 bits: relative errors of a few 2^-106, and numbers that are not finite.
#include "numerics/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace {

using namespace sigmasweep;

constexpr double infinity = std::numeric_limits<double>::infinity();

DoubleDouble drawn(Random& random) {
  const double high = std::ldexp(random(-1.0, 1.0), int(random(-40.0, 40.0)));
  return DoubleDouble(high) + DoubleDouble(high * 0x1p-53 * random(-1.0, 1.0));
}

/// In units of 2^-104, numeric_limits' epsilon.
double error(const DoubleDouble& found, const Quad& wanted, const Quad& size) {
  return static_cast<double>(abs(Quad(found.wide() - wanted)) / abs(size)) * 0x1p104;
}

TEST(DoubleDouble, IsAsExactAsItsEpsilonSays) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const DoubleDouble a = drawn(random), b = drawn(random);
    const Quad x = a.wide(), y = b.wide();
    const Quad both = abs(x) + abs(y);  // 113 bits do not hold all of a
    EXPECT_LE(error(a + b, x + y, both), 1.0);
    EXPECT_LE(error(a - b, x - y, both), 1.0);
    EXPECT_LE(error(a * b, x * y, x * y), 2.0);
    EXPECT_LE(error(a / b, x / y, x / y), 4.0);
  }
}

TEST(DoubleDouble, FunctionsHaveAllDigits) {
  const DoubleDouble third = DoubleDouble(1) / 3;
  const Quad x = third.wide();
  EXPECT_LE(error(sqrt(third), sqrt(x), sqrt(x)), 1.0);
  EXPECT_LE(error(exp(third), exp(x), exp(x)), 1.0);
  EXPECT_LE(error(sin(third), sin(x), sin(x)), 1.0);
  EXPECT_LE(error(cos(third), cos(x), cos(x)), 1.0);
  EXPECT_LE(error(atan2(third, DoubleDouble(2)), atan2(x, Quad(2)), x), 1.0);
}

TEST(DoubleDouble, ComparesTheLastBits) {
  const DoubleDouble one = 1, more = one + std::numeric_limits<DoubleDouble>::epsilon();
  EXPECT_LT(one, more);
  EXPECT_GT(more, one);
  EXPECT_FALSE(one == more);
  EXPECT_LT(-more, -one);
}

TEST(DoubleDouble, InfinitiesStay) {
  const DoubleDouble never = std::numeric_limits<DoubleDouble>::infinity(), one = 1;
  for (const DoubleDouble& x : {never + one, one + never, never - one, never * one, never / one, never + never})
    EXPECT_EQ(x, never);
  EXPECT_EQ(one / DoubleDouble(0), never);
  EXPECT_EQ(one / never, DoubleDouble(0));
  EXPECT_TRUE(std::isnan(static_cast<double>(never - never)));
  EXPECT_FALSE(never - never < one);
  EXPECT_EQ(static_cast<double>(never), infinity);
}

}  // namespace
