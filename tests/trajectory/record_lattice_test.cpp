#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "assembly/ground.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

constexpr double v0 = 0.5, tc = 2e-5, d = 1e-3;

/// 4 rows of 3; v0 tc = 1e-5 m.
Parameters four_rows(double sigma, SideWalls side_walls = SideWalls::periodic, double D_t = 0.0) {
  return lattice({.v0 = v0,
                  .tc = tc,
                  .sigma = sigma,
                  .epsilon = 0.9,
                  .d = d,
                  .D_t = D_t,
                  .rows = 4,
                  .columns = 3,
                  .seed = 5,
                  .side_walls = side_walls,
                  .random_separation = sigma > 0.0 ? Flag::yes : Flag::no});
}

std::vector<Parameters> all_kinds() {
  std::vector<Parameters> all;
  for (const double sigma : {0.0, 0.3, 3.0})
    for (const SideWalls side_walls : {SideWalls::periodic, SideWalls::fixed})
      for (const double D_t : {0.0, 2000.0}) all.push_back(four_rows(sigma, side_walls, D_t));
  all[5].width = 1e-4;
  return all;
}

Trajectory filmed(const Parameters& p, double duration, std::size_t samples) {
  return record(p, sample_times(duration, samples));
}

/// Kinetic energy over that at the start.
double kinetic(const Trajectory& t, std::size_t sample) {
  double energy = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < t.beads(); ++i) {
    const std::size_t k = sample * t.beads() + i;
    energy += t.mass[i] * (std::pow(t.velocity[k], 2) + std::pow(t.x_velocity[k], 2));
    mass += t.mass[i];
  }
  return energy / (mass * v0 * v0);
}

/// The springs' energy over the kinetic energy at the start: K x^2/2 with K = m_red omega0^2, Eqs. (2)-(7), of pairs
/// (the nearest image) and walls alike.
double elastic(const Trajectory& t, std::size_t sample) {
  const double L = -std::log(0.9), K = 0.5 * (std::pow(std::numbers::pi / tc, 2) + std::pow(L / tc, 2));
  double sum = 0.0, mass = 0.0;
  const auto squeeze = [&](double gap) { sum += gap < 0.0 ? gap * gap : 0.0; };
  for (std::size_t i = 0; i < t.beads(); ++i) {
    mass += t.mass[i];
    const std::size_t k = sample * t.beads() + i;
    const double r = 0.5 * t.diameter[i];
    squeeze(t.z[k] - r);
    if (!t.periodic) {
      squeeze(t.x[k] - r);
      squeeze(t.box_width - t.x[k] - r);
    }
    for (std::size_t j = 0; j < i; ++j) {
      double dx = t.x[k] - t.x[sample * t.beads() + j];
      if (t.periodic) dx -= t.box_width * std::round(dx / t.box_width);
      squeeze(std::hypot(dx, t.z[k] - t.z[sample * t.beads() + j]) - r - 0.5 * t.diameter[j]);
    }
  }
  return K * sum / (mass * v0 * v0);
}

TEST(LatticeTrajectory, StartsAsGiven) {
  for (const SideWalls side_walls : {SideWalls::periodic, SideWalls::fixed}) {
    Parameters p = four_rows(0.3, side_walls);
    p.random_separation = Flag::no;
    const double a = d + p.s0;
    const Trajectory t = filmed(p, 1e-7, 2);
    ASSERT_TRUE(t.is_plane());
    ASSERT_EQ(t.beads(), 12u);
    ASSERT_EQ(t.x.size(), 24u);
    const bool periodic = side_walls == SideWalls::periodic;
    EXPECT_EQ(t.periodic, periodic);
    EXPECT_NEAR(t.box_width, periodic ? 3 * a : 3.5 * a + p.s0, 1e-17);  // roundings of mm
    for (std::size_t i = 0; i < 12; ++i) {
      const double row = double(i / 3), place = double(i % 3) + (i / 3 % 2 == 1 ? 0.5 : 0.0);
      EXPECT_NEAR(t.z[i], d / 2 + p.s0 + row * a * std::sqrt(3.0) / 2, 1e-17);
      EXPECT_NEAR(t.x[i] - t.x[0], place * a, 1e-17);
      EXPECT_NEAR(t.velocity[i], -v0, 1e-15);
      EXPECT_EQ(t.x_velocity[i], 0.0);
      EXPECT_NEAR(t.z[12 + i] - t.z[i], -v0 * 1e-7, 1e-17);  // still falling
      EXPECT_EQ(t.mass[i], 1.0);
      EXPECT_EQ(t.diameter[i], d);
    }
    if (!periodic) {
      EXPECT_NEAR(t.x[0], d / 2 + p.s0, 1e-17);
    }
  }
}

TEST(LatticeTrajectory, ShiftsAreSmallAndMakeNoOverlap) {
  for (const Parameters& p : all_kinds()) {
    if (p.s0 == 0.0) continue;
    Parameters still = p;
    still.random_separation = Flag::no;
    const Trajectory t = filmed(p, 1e-9, 2), sites = filmed(still, 1e-9, 2);
    double most = 0.0;
    for (std::size_t i = 0; i < t.beads(); ++i)
      for (const double shift : {t.x[i] - sites.x[i], t.z[i] - sites.z[i]}) {
        EXPECT_LE(std::abs(shift), p.s0 / 2 + 1e-17);
        most = std::max(most, std::abs(shift));
      }
    EXPECT_GT(most, p.s0 / 10);
    EXPECT_EQ(elastic(t, 0), 0.0);
  }
}

/// simulate() ends when nothing has touched for 2 N (s0 + width)/v0: the film has a quiet of that length, and in
/// the first one the beads have the energy of eps_eff. Its tolerance is 1e-10; the film's own errors are some 1e-12.
TEST(LatticeTrajectory, EndsWithTheEnergyOfTheResult) {
  for (const Parameters& p : all_kinds()) {
    if (p.s0 == 0.0) continue;
    const SimulationResult c = simulate(p);
    ASSERT_EQ(c.status, Status::ok);
    const double quiet = 2 * 12 * (p.s0 + p.width) / v0, duration = show_time(p, c) + 20 * quiet, step = quiet / 40;
    const Trajectory t = filmed(p, duration, static_cast<std::size_t>(duration / step));
    std::size_t begin = 0, s = 0;
    double energy = -1.0;
    while (++s < t.samples() && (energy < 0.0 || s - begin < 39)) {  // in 39 steps of quiet/40 nothing happens
      if (const double now = kinetic(t, s); std::abs(now - energy) > 1e-13 || c.t_k + p.s0 / v0 / 2 > t.time[s]) {
        begin = s;
        energy = now;
      }
    }
    ASSERT_LT(s, t.samples());
    EXPECT_NEAR(std::sqrt(energy), c.eps_eff, 2e-10) << p.sigma << " " << int(p.side_walls) << " " << p.D_t;
  }
}

/// Between side walls beads would meet again and again.
TEST(LatticeTrajectory, InTouchEndsWithTheEnergyOfTheResult) {
  for (const Parameters& p : all_kinds()) {
    if (p.s0 > 0.0 || p.side_walls == SideWalls::fixed) continue;
    const SimulationResult c = simulate(p);
    const Trajectory t = filmed(p, 1000 * show_time(p, c), 3);
    EXPECT_NEAR(std::sqrt(kinetic(t, 2)), c.eps_eff, 2e-10) << int(p.side_walls) << " " << p.D_t;
  }
}

/// Dashpots only take. An overlap of 1e-6 m in positions of 4e-3 m has an error of 1e-18, 1e-12 of itself.
TEST(LatticeTrajectory, EnergyNeverRises) {
  for (const Parameters& p : all_kinds()) {
    if (p.width > 0.0) continue;  // other springs
    const Trajectory t = filmed(p, show_time(p, simulate(p)), 1001);
    double before = 1.0, max_elastic = 0.0;
    for (std::size_t s = 0; s < t.samples(); ++s) {
      const double springs = elastic(t, s), energy = kinetic(t, s) + springs;
      EXPECT_LE(energy, before + 1e-10) << p.sigma << " " << int(p.side_walls) << " " << p.D_t << " " << t.time[s];
      before = energy;
      max_elastic = std::max(max_elastic, springs);
    }
    EXPECT_GT(max_elastic, 0.05);
    EXPECT_LT(before, 0.96);
  }
}

/// Without friction at the bottom and without side walls nothing pushes sideways.
TEST(LatticeTrajectory, HorizontalMomentumStaysZero) {
  for (const Parameters& p : all_kinds()) {
    if (p.D_t > 0.0 || p.side_walls == SideWalls::fixed) continue;
    const Trajectory t = filmed(p, show_time(p, simulate(p)), 201);
    double fastest = 0.0;
    for (std::size_t s = 0; s < t.samples(); ++s) {
      double momentum = 0.0;
      for (std::size_t i = 0; i < t.beads(); ++i) {
        momentum += t.mass[i] * t.x_velocity[s * t.beads() + i];
        fastest = std::max(fastest, std::abs(t.x_velocity[s * t.beads() + i]));
      }
      EXPECT_NEAR(momentum, 0.0, 12 * 1e-11 * v0);  // local errors of 1e-12, some for each contact
    }
    EXPECT_EQ(fastest > 1e-4 * v0, p.s0 > 0.0);  // on a perfect lattice beads go up and down only
  }
}

TEST(LatticeTrajectory, PositionsFollowFromVelocities) {
  for (const Parameters& p : all_kinds()) {
    const double duration = show_time(p, simulate(p)), h = 1e-4 * tc;
    std::vector<double> times;
    for (const double middle : sample_times(duration, 50))
      for (const double when : {middle + h, middle + 2 * h, middle + 3 * h}) times.push_back(when);
    const Trajectory t = record(p, times);
    const std::size_t N = t.beads();
    // In h the velocity changes by h times some omega0 v0, and of several contacts; 1e-17 m is rounding.
    const double tolerance = 30 * h / tc * v0 + 1e-17 / h;
    for (std::size_t s = 0; s < times.size(); s += 3)
      for (std::size_t i = 0; i < N; ++i) {
        const double dt = times[s + 2] - times[s];
        EXPECT_NEAR((t.z[(s + 2) * N + i] - t.z[s * N + i]) / dt, t.velocity[(s + 1) * N + i], tolerance);
        EXPECT_NEAR((t.x[(s + 2) * N + i] - t.x[s * N + i]) / dt, t.x_velocity[(s + 1) * N + i], tolerance);
      }
  }
}

/// Samples are looked at, not stepped to.
TEST(LatticeTrajectory, SamplesDoNotDependOnOneAnother) {
  for (const Parameters& p : all_kinds()) {
    const std::vector<double> all = sample_times(4e-4, 101), some{all[0], all[17], all[60], all[99]};
    const Trajectory many = record(p, all), few = record(p, some);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(few.x[12 + i], many.x[17 * 12 + i]);
      EXPECT_EQ(few.z[24 + i], many.z[60 * 12 + i]);
      EXPECT_EQ(few.velocity[36 + i], many.velocity[99 * 12 + i]);
    }
  }
}

TEST(LatticeTrajectory, FixedStepsComeCloseToTheExactOne) {
  for (const Integrator integrator : {Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog})
    for (const double sigma : {0.0, 0.3}) {
      const double duration = 10 * tc;
      Parameters p = four_rows(sigma);
      const Trajectory exact = filmed(p, duration, 101);
      p.integrator = integrator;
      p.steps_per_tc = 1000;
      const Trajectory t = filmed(p, duration, 101);
      for (std::size_t k = 0; k < t.z.size(); ++k) {
        EXPECT_NEAR(t.z[k], exact.z[k], 1e-3 * v0 * duration);  // first order: some steps' worth of the speed
        EXPECT_NEAR(t.x[k], exact.x[k], 1e-3 * v0 * duration);
        EXPECT_NEAR(t.velocity[k], exact.velocity[k], 2e-2 * v0);
      }
    }
}

TEST(LatticeTrajectory, ShowTime) {
  const Parameters p = four_rows(3.0);
  SimulationResult c;
  EXPECT_TRUE(std::isnan(show_time(p, c)));
  c.t_k = 5 * tc;
  EXPECT_NEAR(show_time(p, c), 1.5 * 8 * tc, 1e-15 * tc);
  c.t_k = 1e6 * tc;
  EXPECT_NEAR(show_time(p, c), (3 + 3 * 4 * 4) * tc, 1e-13 * tc);  // 3 rows (1 + sigma)
}

/// In the room: the beads start with the plate's speed, and their mean height is that of the table.
TEST(LatticeTrajectory, OfAVibratedLattice) {
  Parameters p = four_rows(0.1);
  p.tc = 5e-4;
  p.frequency = 20.0;
  p.alpha = 2.0;
  p.periods = 1;
  p.transient = 0;
  p.sigma = 0.0;  // of no meaning there
  p = vibrated_lattice(p);
  const SimulationResult c = simulate(p);
  ASSERT_EQ(c.status, Status::ok);
  std::vector<double> times{0.0};  // and the moments of the averages
  for (int s = 0; s < 256; ++s) times.push_back((s + 0.5) / 256.0 / p.frequency);
  const Trajectory t = record(p, times);
  double sum = 0.0;
  for (std::size_t i = 0; i < t.beads(); ++i) EXPECT_NEAR(t.velocity[i], plate_speed(p, 0.0), 1e-12);
  for (std::size_t k = t.beads(); k < t.z.size(); ++k) sum += t.z[k];
  EXPECT_NEAR(sum / double(t.z.size() - t.beads()), c.vibration.h_cm, 1e-9 * p.d);
}

}  // namespace
}  // namespace sigmasweep
