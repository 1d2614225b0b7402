#include "sigmasweep/contact/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/quad.hpp"

namespace sigmasweep {
namespace {

/// A contact as its differential equation has it: from x = 0, x' = 1 by small steps of a fourth-order scheme to the
/// next x = 0 (the last step by bisection). Independent of the closed formulas.
struct Contact {
  double duration, restitution;
};

Contact integrate(const Oscillator<double>& o, double h) {
  const auto a = [&](double x, double v) { return -2.0 * o.mu * v - o.omega0_2 * x; };
  const auto step = [&](double& x, double& v, double dt) {
    const double v1 = v, a1 = a(x, v);
    const double v2 = v + 0.5 * dt * a1, a2 = a(x + 0.5 * dt * v1, v2);
    const double v3 = v + 0.5 * dt * a2, a3 = a(x + 0.5 * dt * v2, v3);
    const double v4 = v + dt * a3, a4 = a(x + dt * v3, v4);
    x += dt * (v1 + 2 * v2 + 2 * v3 + v4) / 6.0;
    v += dt * (a1 + 2 * a2 + 2 * a3 + a4) / 6.0;
  };
  double x = 0.0, v = 1.0, t = 0.0;
  for (;;) {
    double x_new = x, v_new = v;
    step(x_new, v_new, h);
    if (x_new <= 0.0) break;
    x = x_new, v = v_new, t += h;
  }
  double low = 0.0, high = h;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    double xm = x, vm = v;
    step(xm, vm, middle);
    (xm > 0.0 ? low : high) = middle;
  }
  step(x, v, low);
  return {t + low, -v};
}

TEST(Calibration, GivesContactsOfTheWantedDurationAndRestitution) {
  for (const double eps : {0.05, 0.3, 0.6, 0.9, 0.99, 1.0}) {
    const double tc = 0.8;
    const Contact c = integrate(oscillator(tc, eps), tc / 4000);
    // Fourth order: (omega0 h)^4 ~ 1e-12 at the strongest damping.
    EXPECT_NEAR(c.duration, tc, 1e-10) << eps;
    EXPECT_NEAR(c.restitution, eps, 1e-10) << eps;
  }
}

TEST(Calibration, GivesTheWallItsOwnContact) {
  for (const double eps : {0.05, 0.6, 0.9, 1.0}) {
    const Oscillator<double> pair = oscillator(1.0, eps);
    const Contact c = integrate(wall_of(pair), 1.0 / 4000);
    EXPECT_NEAR(c.restitution, wall_restitution(eps), 1e-10) << eps;
    EXPECT_NEAR(c.duration, contact_time(wall_of(pair)), 1e-10) << eps;
  }
}

TEST(Calibration, WallRestitutionHasTheReferenceValues) {
  // From 18-digit arithmetic; good to the last digit of a double.
  EXPECT_DOUBLE_EQ(wall_restitution(0.95), 0.964382364479186830);
  EXPECT_DOUBLE_EQ(wall_restitution(0.9), 0.928225857266253452);
  EXPECT_DOUBLE_EQ(wall_restitution(0.8), 0.854201911780941295);
  EXPECT_DOUBLE_EQ(wall_restitution(0.6), 0.698483182976482638);
  EXPECT_EQ(wall_restitution(1.0), 1.0);
}

TEST(Calibration, SteelBeadsOfThePaper) {
  // Sec. III: eps = 0.9, omega0 = 6.8e5 /s, mu = 2.3e4 /s, to two digits; tc = 4.6e-6 s.
  const Oscillator<double> steel = oscillator(4.6e-6, 0.9);
  EXPECT_NEAR(std::sqrt(steel.omega0_2), 6.8e5, 0.05e5);
  EXPECT_NEAR(steel.mu, 2.3e4, 0.05e4);
}

template <class Real>
class CalibrationOf : public testing::Test {};
using Reals = testing::Types<double, long double, Quad>;
TYPED_TEST_SUITE(CalibrationOf, Reals);

TYPED_TEST(CalibrationOf, InvertsToRounding) {
  using Real = TypeParam;
  using std::abs;
  const Real rounding = std::numeric_limits<Real>::epsilon();
  for (const double eps : {1e-12, 1e-3, 0.1, 0.5, 0.9, 0.999, 1.0})
    for (const double tc : {1e-9, 3e-5, 1.0, 1e6}) {
      const Oscillator<Real> pair = oscillator<Real>(Real(tc), Real(eps));
      // omega0^2 - mu^2 loses up to (mu/omega)^2 ~ 80 roundings; exp multiplies that of its argument, up to 28.
      EXPECT_LE(abs(contact_time(pair) / Real(tc) - 1), 200 * rounding) << eps << " " << tc;
      EXPECT_LE(abs(restitution(pair) / Real(eps) - 1), 4000 * rounding) << eps << " " << tc;
      EXPECT_LE(abs(restitution(wall_of(pair)) / wall_restitution(Real(eps)) - 1), 4000 * rounding) << eps;
    }
}

TYPED_TEST(CalibrationOf, HasNoContactTimeWhereOverdamped) {
  using Real = TypeParam;
  for (const double mu : {2.0, 3.0}) {
    const Oscillator<Real> o{Real(mu), Real(4)};
    EXPECT_FALSE(contact_time(o) == contact_time(o));
    EXPECT_FALSE(restitution(o) == restitution(o));
  }
}

}  // namespace
}  // namespace sigmasweep
