#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/hard_spheres/vibrated.hpp"
#include "solve/hard_spheres/vibrated_column.hpp"
#include "solve/plain_vibrated.hpp"

/// Hard spheres that rest on the vibrating plate once in a while: a ball that loses all, and columns that do as it
/// does.
namespace sigmasweep {
namespace {

/// A ball that loses all at each landing: it rests on the plate up to phase asin(1/alpha), flies, and rests.
struct InelasticBall {
  double alpha, start, flight, impact;

  explicit InelasticBall(double a) : alpha(a), start(std::asin(1.0 / a)), flight(0.0), impact(0.0) {
    double low = 0.0, high = turn;  // just above the plate, and within it
    while (above(low += 1e-2) <= 0.0) {
    }
    high = low;
    while (above(high += 1e-3) > 0.0) {
    }
    for (int i = 0; i < 100; ++i) (above(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    flight = low;
    impact = alpha * std::cos(start + flight) - (alpha * std::cos(start) - flight);
  }
  double height(double t) const {  // after take-off
    return alpha * std::sin(start) + alpha * std::cos(start) * t - 0.5 * t * t;
  }
  double above(double t) const { return height(t) - alpha * std::sin(start + t); }
  int periods() const { return static_cast<int>(std::ceil(flight / turn)); }  // from take-off to take-off
  double load_at_landing() const { return 1.0 - alpha * std::sin(start + flight); }
  /// The integrals over the parabola of the flight and over the plate's motion until the next take-off.
  double mean_height() const {
    const double f = flight, slope = alpha * std::cos(start);
    const double flying = alpha * std::sin(start) * f + slope * f * f / 2 - f * f * f / 6;
    const double resting = alpha * std::cos(start + f) - slope;
    return (flying + resting) / (turn * periods());
  }
};

/// What eps = 1e-6 leaves of a bounce is 1e-12 high; but near alpha = 1 the flights themselves are short.
class TotallyInelastic : public testing::TestWithParam<double> {};

TEST_P(TotallyInelastic, BallRestsOncePerPeriod) {
  const InelasticBall ball(GetParam());
  ASSERT_LT(ball.flight, turn);
  Parameters p = vibrated(1, 1e-6, GetParam());
  p.wall = Wall::matched;
  const SimulationResult c = run(p);
  EXPECT_EQ(c.status, Status::collapsed);
  EXPECT_NEAR(excess(p, c), ball.mean_height(), 1e-12 * GetParam());
  EXPECT_NEAR(c.vibration.cm_period * p.frequency, 1.0, 1e-12);
  const double speed = unit_length(p) * turn * p.frequency;
  const double lost = 0.5 * ball.impact * ball.impact * speed * speed * p.frequency;
  EXPECT_NEAR(c.vibration.power_lost, lost, 1e-10 * lost + 1e-15 * speed * speed * p.frequency);
  EXPECT_NEAR(c.vibration.power_in, lost, 1e-10 * lost + 1e-15 * speed * speed * p.frequency);
}

TEST_P(TotallyInelastic, ColumnOfTenThatCollapsesMovesAsThatBall) {
  for (const double epsilon : {0.6, 0.3}) {  // Figs. 5 and 6: eps_eff = 0
    const Parameters p = vibrated(10, epsilon, GetParam());
    const SimulationResult c = run(p);
    EXPECT_EQ(c.status, Status::collapsed);
    EXPECT_NEAR(excess(p, c), InelasticBall(GetParam()).mean_height(), 1e-12 * GetParam());
    EXPECT_EQ(c.vibration.separation, 0.0);
    EXPECT_EQ(c.vibration.separation_max, 0.0);
    EXPECT_NEAR(c.vibration.cm_period * p.frequency, 1.0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Alphas, TotallyInelastic, testing::Values(1.05, 1.3, 2.0, 2.7, 3.29));

// Above sqrt(1 + pi^2) = 3.297 the ball comes down onto a plate that lets go at once. It then leaves at the phase at
// which a flight takes a period, alpha cos(phase) = pi; landing phases near it come back to it with the factor
// 1 - alpha sin(phase) = 1 - sqrt(alpha^2 - pi^2) a period, so up to sqrt(4 + pi^2) = 3.724. Mean height of that
// flight: alpha sin(phase) + pi^2/3. A. Mehta & J. M. Luck, Phys. Rev. Lett. 65, 393 (1990).
TEST(TotallyInelasticBall, LeavesAtOnce) {
  for (const double alpha : {3.31, 3.5, 3.6}) {
    Parameters p = vibrated(1, 1e-9, alpha, 400, 300);
    p.wall = Wall::matched;
    const SimulationResult c = run(p);
    EXPECT_NEAR(c.vibration.cm_period * p.frequency, 1.0, 1e-12);
    // It leaves at the speed alpha cos(phase) + epsilon (alpha cos(phase) + pi), which is pi.
    const double slope = pi * (1.0 - 1e-9) / (1.0 + 1e-9);
    EXPECT_NEAR(excess(p, c), std::sqrt(alpha * alpha - slope * slope) + pi * pi / 3, 1e-12 * alpha);
  }
}

TEST(TotallyInelasticBall, PeriodDoubles) {
  for (const double alpha : {3.74, 3.8}) {
    Parameters p = vibrated(1, 1e-9, alpha, 1500, 1300);
    p.wall = Wall::matched;
    EXPECT_NEAR(run(p).vibration.cm_period * p.frequency, 2.0, 1e-12) << alpha;
  }
}

// Near and just above alpha = (n + 1/2) pi, what has rested on the plate comes down, 2 alpha later, hardly faster than
// the plate: so softly that under a load of many g it is at rest again before the next take-off. Period n + 1 for ever:
// one with bounces is locked as one without (J. M. Luck & A. Mehta, Phys. Rev. E 48, 3988 (1993)), ten beads of
// N(1-eps) = 0.8 as one. Started otherwise, they go on in random motion about five times as high.
class SoftLanding : public testing::TestWithParam<double> {
 protected:
  const InelasticBall ball{GetParam()};

  void expect_locked(Parameters p) const {
    p.periods = 6 * ball.periods();
    p.transient = ball.periods();
    const SimulationResult c = simulate(vibrated_column(p));
    ASSERT_TRUE(is_success(c.status)) << name_of(c.status);
    EXPECT_NEAR(c.vibration.cm_period * p.frequency, ball.periods(), 1e-12);
    // The centre of mass bounces no higher than the impact's energy takes it under the load at landing, which is that
    // or more as long after phase 3/2 pi as the landing is before it.
    const double phase = ball.start + ball.flight - turn * (ball.periods() - 1), load = ball.load_at_landing();
    ASSERT_LT(phase, 1.5 * pi);
    ASSERT_GT(load, 4.0);
    const double share = (3.0 * pi - 2.0 * phase) / (turn * ball.periods());
    EXPECT_NEAR(excess(p, c), ball.mean_height(), share * ball.impact * ball.impact / (2.0 * load));
  }
};

TEST_P(SoftLanding, LocksAColumnThatWouldFlyApart) {
  for (const Wall wall : {Wall::paper, Wall::matched}) {
    Parameters p = vibrated(10, 0.92, GetParam());
    p.wall = wall;
    expect_locked(p);
  }
}

INSTANTIATE_TEST_SUITE_P(Alphas, SoftLanding, testing::Values(4.72, 7.86, 11.0, 14.14, 17.29));

// Another program and another law, that knows no rest. tc is so short that what a landing leaves of the column's own
// oscillations is gone at take-off: at 2e-6 s the beads part after a few landings.
using SoftLandingOfSoftSpheres = SoftLanding;
TEST_P(SoftLandingOfSoftSpheres, LocksThem) {
  Parameters p = vibrated(10, 0.92, GetParam());
  p.method = Method::md;
  p.tc = 3e-7;
  expect_locked(p);
}

INSTANTIATE_TEST_SUITE_P(Alphas, SoftLandingOfSoftSpheres, testing::Values(11.0));

TEST(SoftLandingOfTen, EndsBouncesInThePlainProgramToo) {
  constexpr double alpha = 11.0, wall = 0.94;
  std::vector<double> gaps(10, 1e-4);
  gaps[0] = 0.01;  // the plate falls away before it could touch
  plain_vibrated::Plain plain(alpha, 0.92, wall, gaps);
  while (plain.collisions < 1000) plain.advance(plain.now + 0.1);
  // No rest there, but no bead can rise for longer than this, and the plate lets go 2.5 later.
  EXPECT_GT(plain.now, 3 * turn + pi);
  EXPECT_LT(plain.now, 3 * turn + 3.9);
  plain_vibrated::Long energy = 0.0;
  for (const plain_vibrated::Long v : plain.v) energy += 0.5L * std::pow(v - alpha * std::cos(plain.now), 2.0L);
  EXPECT_LT(std::sqrt(2.0L * energy), 0.02);

  Film film{.N = gaps.size(), .alpha = alpha, .periods = 4};
  VibratedHardSpheres spheres(column(gaps, 0.92, wall), Plate{1.0, alpha, 1.0}, {});
  spheres.run(film);
  for (const double z : film.z.back()) EXPECT_EQ(z, alpha * std::sin(Film::moment(Film::samples - 1)));
}

TEST(SoftLandingOfTen, IsMissedByOtherStarts) {
  Parameters p = vibrated(10, 0.92, 11.0, 500, 20);
  p.s0 = 3e-3;
  const double X = 0.8, speed = 11.0 * unit_length(p) * turn * p.frequency;  // Eq. (10)
  const double paper = 4.0 / 3.0 * speed * speed / p.gravity * (1.0 - 0.098 * X - 0.073 * X * X) / X;
  const double ratio = run(p).vibration.h_cm_excess / paper;
  EXPECT_GT(ratio, 0.8);
  EXPECT_LT(ratio, 1.1);
}

}  // namespace
}  // namespace sigmasweep
