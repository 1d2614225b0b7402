#include "sigmasweep/trajectory/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

/// Ten beads of Fig. 1; s0 in m.
Parameters figure_1(double s0, Method method = Method::md, Integrator integrator = Integrator::exact) {
  Parameters p{.v0 = 0.2, .tc = 0.7e-5, .s0 = s0, .epsilon = 0.9};
  p.N = 10;
  p.method = method;
  p.integrator = integrator;
  return completed(p);
}

std::vector<Parameters> all_kinds() {
  std::vector<Parameters> all;
  for (const double s0 : {0.0, 1e-6, 1e-5}) {
    all.push_back(figure_1(s0, Method::ed));
    for (const Integrator i : values_of<Integrator>()) all.push_back(figure_1(s0, Method::md, i));
  }
  return all;
}

Trajectory filmed(const Parameters& p, double duration, std::size_t samples) {
  return record(p, sample_times(duration, samples));
}

TEST(Trajectory, StartsAsGiven) {
  for (const Parameters& p : all_kinds()) {
    const Trajectory t = filmed(p, 1e-7, 2);
    ASSERT_EQ(t.beads(), 10u);
    ASSERT_EQ(t.z.size(), 20u);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_NEAR(t.z[i], double(i + 1) * p.s0, 1e-15 * 10 * p.s0);  // a rounding a gap
      EXPECT_NEAR(t.velocity[i], -0.2, 1e-15);
      EXPECT_EQ(t.mass[i], 1.0);
      EXPECT_NEAR(t.base(i), (double(i) + 0.5) * 1e-3, 1e-17);
    }
  }
}

/// x'' + mu x' + omega0^2/2 x = 0 at the paper's wall for a bead that comes with v0, Eqs. (2)-(7).
TEST(Trajectory, OneBeadIsADampedOscillator) {
  Parameters p = figure_1(1e-6);
  p.N = 1;
  const double L = -std::log(0.9), mu = L / p.tc, omega0_2 = std::pow(std::numbers::pi / p.tc, 2) + mu * mu;
  const double omega = std::sqrt(omega0_2 / 2 - mu * mu / 4);
  const double contact = 1e-6 / 0.2, end = contact + std::numbers::pi / omega;
  const Trajectory t = filmed(p, 2e-5, 401);
  for (std::size_t s = 0; s < t.samples(); ++s) {
    const double now = t.time[s] - contact, decay = std::exp(-mu / 2 * now);
    double z = -0.2 * now, v = -0.2;  // falling
    if (t.time[s] > end) {
      v = 0.2 * std::exp(-mu / 2 * std::numbers::pi / omega);
      z = v * (t.time[s] - end);
    } else if (now > 0.0) {
      z = -0.2 / omega * decay * std::sin(omega * now);
      v = -0.2 * decay * (std::cos(omega * now) - mu / 2 / omega * std::sin(omega * now));
    }
    EXPECT_NEAR(t.z[s], z, 1e-14 * 1e-6);  // tens of roundings of the largest numbers
    EXPECT_NEAR(t.velocity[s], v, 1e-14 * 0.2);
  }
}

/// The flight of two hard beads by hand, eps = eps_wall = 1/2: see HardSpheres.TwoBeadsByHand.
TEST(Trajectory, TwoHardBeadsByHand) {
  Parameters p{.v0 = 1.0, .s0 = 1.0, .epsilon = 0.5};
  p.N = 2;
  p.method = Method::ed;
  p.wall = Wall::matched;
  p = completed(p);
  const std::vector<double> times{0.0, 0.5, 1.0, 1.5, 2.0, 2.2, 3.0, 16.0 / 3.0};
  const std::vector<double> z1{1.0, 0.5, 0.0, 0.25, 1.0 / 3 - 5.0 / 24, 0.0, 0.25, 2.0 / 3 + 11.0 / 64};
  const std::vector<double> z2{2.0, 1.5, 1.0, 0.5, 1.0 / 3 + 1.0 / 24, 0.4, 0.5, 2.0 / 3 + 17.0 / 64};
  const Trajectory t = record(p, times);
  for (std::size_t s = 0; s < times.size(); ++s) {
    EXPECT_NEAR(t.z[2 * s], z1[s], 1e-14) << times[s];
    EXPECT_NEAR(t.z[2 * s + 1], z2[s], 1e-14) << times[s];
  }
  EXPECT_EQ(t.velocity[4], -1.0);  // just before the wall
  EXPECT_NEAR(t.velocity[14], 11.0 / 64, 1e-15);
  EXPECT_NEAR(t.velocity[15], 17.0 / 64, 1e-15);
}

TEST(Trajectory, HardBeadsInTouchFlyApartInOrder) {
  const Trajectory t = filmed(figure_1(0.0, Method::ed), 1e-4, 11);
  for (std::size_t s = 1; s < t.samples(); ++s)
    for (std::size_t i = 0; i < 10; ++i) {
      const double v = t.velocity[s * 10 + i], below = i == 0 ? 0.0 : t.velocity[s * 10 + i - 1];
      EXPECT_GT(v, below);
      EXPECT_NEAR(t.z[s * 10 + i], v * t.time[s], 1e-14 * 1e-4 * 0.2);
    }
}

/// What is left after the settled end is 1e-13 of eps_eff (the solvers' settle), its square root of a velocity.
TEST(Trajectory, EndsWithTheEnergyOfTheResult) {
  for (const Parameters& p : all_kinds()) {
    const SimulationResult c = simulate(p);
    const Trajectory t = filmed(p, 1000 * show_time(p, c), 3);
    double energy = 0.0, momentum = 0.0;
    for (std::size_t i = 0; i < 10; ++i) {
      energy += std::pow(t.velocity[20 + i] / p.v0, 2) / 10.0;
      momentum += t.velocity[20 + i] / p.v0 / 10.0;
    }
    EXPECT_NEAR(std::sqrt(energy), c.eps_eff, 1e-12) << p.s0 << " " << int(p.method) << int(p.integrator);
    EXPECT_NEAR(momentum, c.v_cm, 1e-6);
  }
}

TEST(Trajectory, HeightsFollowFromVelocities) {
  for (const Parameters& p : all_kinds()) {
    if (p.method == Method::ed) continue;
    const double duration = show_time(p, simulate(p)), h = 1e-4 * p.tc;
    std::vector<double> times;
    for (const double middle : sample_times(duration, 100))
      for (const double t : {middle + h, middle + 2 * h, middle + 3 * h}) times.push_back(t);
    const Trajectory t = record(p, times);
    // Between two samples the rate changes by h times the largest acceleration, some omega0 v0; fixed steps have one
    // of tc/100 for their own, in which the rates are not exactly those of the overlaps.
    const double tolerance = (p.integrator == Integrator::exact ? 10 * h / p.tc : 0.1) * p.v0;
    for (std::size_t s = 0; s < times.size(); s += 3)
      for (std::size_t i = 0; i < 10; ++i) {
        const double slope = (t.z[(s + 2) * 10 + i] - t.z[s * 10 + i]) / (times[s + 2] - times[s]);
        EXPECT_NEAR(slope, t.velocity[(s + 1) * 10 + i], tolerance);
      }
  }
}

/// The wall is all that gives the column momentum, beads of any mass.
TEST(Trajectory, MomentumChangesAtTheWallOnly) {
  for (const double width : {0.0, 0.4e-3}) {
    Parameters p = figure_1(1e-5);
    p.width = width;
    p.random_separation = width > 0.0 ? Flag::yes : Flag::no;
    const SimulationResult c = simulate(p);
    const double duration = show_time(p, c);
    const auto samples = static_cast<std::size_t>(50 * duration / p.tc);  // a contact with the wall takes some tc
    const Trajectory t = filmed(p, duration, samples);
    std::size_t free = 0;
    double before = 0.0;
    for (std::size_t s = 0; s < samples; ++s) {
      double momentum = 0.0;
      for (std::size_t i = 0; i < 10; ++i) momentum += t.mass[i] * t.velocity[s * 10 + i];
      if (s > 0 && t.z[s * 10] > 0.0 && t.z[(s - 1) * 10] > 0.0) {
        ++free;
        EXPECT_NEAR(momentum, before, 1e-13 * 10 * p.v0);
      }
      before = momentum;
    }
    EXPECT_GT(free, samples / 3);
    EXPECT_LT(free, samples - 100);
  }
}

TEST(Trajectory, DeepestOverlapIsTheResults) {
  const Parameters p = figure_1(0.0);
  const Trajectory t = filmed(p, 1e-4, 20001);
  double deepest = 0.0;
  for (std::size_t s = 0; s < t.samples(); ++s)
    for (std::size_t i = 0; i < 10; ++i)
      deepest = std::max(deepest, (i == 0 ? 0.0 : t.z[s * 10 + i - 1]) - t.z[s * 10 + i]);
  const double x_max = simulate(p).x_max;
  EXPECT_LE(deepest, x_max * (1 + 1e-13));
  EXPECT_GT(deepest, x_max * (1 - 1e-5));  // flat there: (omega0 dt)^2/8 with dt = 5e-9 s
}

TEST(Trajectory, FixedStepsComeCloseToTheExactOne) {
  for (const Integrator integrator : {Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog})
    for (const double s0 : {0.0, 1e-6}) {
      const double duration = 1e-4;
      Parameters p = figure_1(s0, Method::md, integrator);
      p.steps_per_tc = 1000;
      const Trajectory exact = filmed(figure_1(s0), duration, 333), t = filmed(p, duration, 333);
      for (std::size_t k = 0; k < t.z.size(); ++k) {
        EXPECT_NEAR(t.z[k], exact.z[k], 1e-3 * p.v0 * duration);  // first order: some steps' worth of the speed
        EXPECT_NEAR(t.velocity[k], exact.velocity[k], 1e-2 * p.v0);
      }
    }
}

/// Samples are looked at, not stepped to: a subset of the times gives the same bits.
TEST(Trajectory, SamplesDoNotDependOnOneAnother) {
  for (const Parameters& p : all_kinds()) {
    const std::vector<double> all = sample_times(2e-4, 101), some{all[0], all[17], all[60], all[99]};
    const Trajectory many = record(p, all), few = record(p, some);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_EQ(few.z[10 + i], many.z[170 + i]);
      EXPECT_EQ(few.z[30 + i], many.z[990 + i]);
      EXPECT_EQ(few.velocity[20 + i], many.velocity[600 + i]);
    }
  }
}

TEST(Trajectory, ShowTime) {
  const Parameters soft = figure_1(1e-6), hard = figure_1(0.0, Method::ed);
  SimulationResult c;
  EXPECT_TRUE(std::isnan(show_time(soft, c)));
  c.t_k = 4e-5;
  EXPECT_NEAR(show_time(soft, c), 1.5 * (5e-6 + 4e-5), 1e-18);
  c.t_k = 0.0;
  EXPECT_NEAR(show_time(hard, c), 1.5 * 10 * 0.7e-5, 1e-18);
}

}  // namespace
}  // namespace sigmasweep
