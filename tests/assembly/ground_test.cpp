#include "assembly/ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/quad.hpp"

namespace sigmasweep {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double alphas[] = {0.0, 0.5, 1.0, 1.0 + 1e-12, 1.0 + 1e-6, 1.5, 3.0, 30.0, 100.0};
constexpr unsigned seed = 1994;

/// The contact in the room's frame, where the plate is where it is and the bead is thrown up at t; 34 digits.
ContactState<Quad> in_room(const Plate& plate, const ContactState<double>& entry, double t, double elapsed) {
  const Quad g = plate.g, A0 = plate.A0, omega = plate.omega, e = elapsed, phase = omega * Quad(t);
  const Quad height = A0 * sin(phase) - Quad(entry.x), speed = A0 * omega * cos(phase) - Quad(entry.u);
  return {A0 * sin(phase + omega * e) - (height + speed * e - g * e * e / 2),
          A0 * omega * cos(phase + omega * e) - (speed - g * e)};
}

/// Of Plate::flight: each term of its sum is rounded a few times, the sines' arguments once; and of 34 digits.
double rounding(const Plate& plate, const ContactState<double>& entry, double t, double elapsed) {
  const double strongest = plate.g + plate.A0 * plate.omega * plate.omega;
  return 8.0 * eps * (1.0 + plate.omega * t) *
             (std::fabs(entry.x) + std::fabs(entry.u) * elapsed + strongest * elapsed * elapsed) +
         1e-32 * plate.A0;
}

class Plates : public testing::TestWithParam<double> {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  /// Of either sign, its size anywhere between 1e-12 and `high`.
  double wide(double high) { return std::copysign(high * std::pow(10.0, uniform(-12.0, 0.0)), uniform(-1.0, 1.0)); }
  Plate any_plate() {
    const double g = uniform(0.1, 20.0), omega = uniform(0.1, 300.0);
    return {g, GetParam() * g / (omega * omega), omega};
  }

  std::mt19937_64 random_{seed};
};

TEST_P(Plates, FlightIsThatOfABallInTheRoom) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  for (int i = 0; i < 2000; ++i) {
    const Plate plate = any_plate();
    const double t = uniform(0.0, plate.period()), elapsed = std::fabs(wide(30.0 / plate.omega));
    const double length = plate.g / (plate.omega * plate.omega);
    const ContactState<double> entry{-std::fabs(wide(100.0 * length)), wide(100.0 * length * plate.omega)};
    const ContactState<double> exit = plate.flight(entry, t, elapsed);
    const ContactState<Quad> expected = in_room(plate, entry, t, elapsed);
    const double error = rounding(plate, entry, t, elapsed);
    EXPECT_NEAR(exit.x, static_cast<double>(expected.x), error);
    EXPECT_NEAR(exit.u, static_cast<double>(expected.u), error / elapsed);
  }
}

TEST_P(Plates, LandingIsTheFirstOne) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  for (int i = 0; i < 100; ++i) {
    const Plate plate = any_plate();
    const double t = uniform(0.0, plate.period()), length = plate.g / (plate.omega * plate.omega);
    ContactState<double> entry{-std::fabs(wide(100.0 * length)), wide(100.0 * length * plate.omega)};
    if (i % 3 == 0) entry = {0.0, -std::fabs(entry.u)};
    const double landing = plate.landing(entry, t);
    ASSERT_GT(landing, 0.0);
    const auto x = [&](double elapsed) { return static_cast<double>(in_room(plate, entry, t, elapsed).x); };
    const ContactState<double> end = plate.flight(entry, t, landing);
    EXPECT_GE(end.u, 0.0);
    // Where the overlap is 0 to rounding, or within a rounding of the time.
    const double error = rounding(plate, entry, t, landing), late = 2.0 * eps * landing;
    EXPECT_LE(std::fabs(x(landing)), error + late * end.u);
    const double step = std::min(landing / 300.0, plate.period() / 100.0);
    for (double before = landing - step; before > 0.0; before -= step)
      ASSERT_LE(x(before), rounding(plate, entry, t, before)) << before << " of " << landing;
  }
}

TEST_P(Plates, HoldUntilTheyLetGo) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Plate plate{1.0, GetParam(), 1.0};
  const double rise = GetParam() > 1.0 ? std::asin(1.0 / GetParam()) : 1.0;
  for (int i = 0; i < 2000; ++i) {
    double t = uniform(0.0, plate.period());
    if (i % 2 == 0) t = (i % 4 == 0 ? rise : std::numbers::pi - rise) + eps * (i % 16 - 8);
    const double take_off = plate.take_off(t);
    if (GetParam() <= 1.0) {
      EXPECT_TRUE(plate.holds(t));
      EXPECT_EQ(take_off, std::numeric_limits<double>::infinity());
      continue;
    }
    EXPECT_EQ(plate.holds(t), take_off > t);
    EXPECT_FALSE(plate.holds(take_off));
    EXPECT_LT(take_off, t + plate.period());
    if (take_off - t < 1e-12) continue;
    EXPECT_NEAR(std::remainder(take_off - rise, plate.period()), 0.0, 16.0 * eps);
    EXPECT_TRUE(plate.holds(t + uniform(0.0, 0.99) * (take_off - t)));
  }
}

TEST_P(Plates, WhatTouchesStaysWhereThePlateHolds) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  for (int i = 0; i < 300; ++i) {
    const Plate plate = any_plate();
    const double t = uniform(0.0, plate.period());
    EXPECT_EQ(plate.landing({0.0, 1e-9}, t), 0.0);
    EXPECT_EQ(plate.landing({1e-9, 1e-9}, t), 0.0);
    const double landing = plate.landing({0.0, 0.0}, t);
    EXPECT_EQ(landing > 0.0, !plate.holds(t));
    EXPECT_EQ(landing > 0.0, plate.load(t) < 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Alphas, Plates, testing::ValuesIn(alphas));

TEST(Plate, AtRestIsHitByAParabola) {
  const Plate plate{9.81, 0.0, 100.0};
  EXPECT_NEAR(plate.landing({0.0, -0.3}, 0.01), 0.6 / 9.81, 2.0 * eps * 0.6 / 9.81);
  EXPECT_NEAR(plate.landing({-1e-3, 0.0}, 0.01), std::sqrt(2e-3 / 9.81), 2.0 * eps);
}

TEST(Plate, IsHitOrMissedByWhatGrazesIt) {
  const Plate plate{1.0, 3.0, 1.0};
  const double top = 1.3, before = 0.8;  // the load is below 0 from phase 0.34 to 2.8: the overlap is highest at `top`
  for (const double height : {1e-6, 1e-9, 1e-12, -1e-12, -1e-9, -1e-6}) {
    const auto back = plate.flight({height, 0.0}, top, -before);
    ASSERT_LT(back.x, -0.1);
    const double landing = plate.landing(back, top - before);
    if (height > 0.0) {  // height = 1/2 |load| (early)^2
      const double early = std::sqrt(2.0 * height / -plate.load(top));
      EXPECT_NEAR(before - landing, early, early * early + 1e-15 / early);
    } else {
      EXPECT_GT(landing, std::numbers::pi - top);
      EXPECT_NEAR(plate.flight(back, top - before, landing).x, 0.0, 32.0 * eps);
    }
  }
}

TEST(Plate, NoNumberEndsInNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan((Plate{1.0, 2.0, 1.0}.landing({nan, 0.0}, 0.0))));
  EXPECT_TRUE(std::isnan((Plate{1.0, 2.0, 1.0}.landing({-1.0, nan}, 0.0))));
  EXPECT_TRUE(std::isnan((Plate{1.0, 0.5, 1.0}.landing({-1.0, 1.0}, nan))));
}

}  // namespace
}  // namespace sigmasweep
