#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "support/parameters.hpp"

/// Averages of vibrated columns against those of the recorded trajectory, by the trapezoidal rule.
namespace sigmasweep {
namespace {

struct Averages {  ///< heights are reduced ones: all gaps are 0 at rest
  double height = 0.0, separation = 0.0, separation_max = 0.0, E_r = 0.0;
};

Averages averages_of(const Trajectory& film, std::size_t first) {
  const std::size_t beads = film.beads(), last = film.samples() - 1;
  Averages a;
  for (std::size_t k = first; k <= last; ++k) {
    const double weight = (k == first || k == last ? 0.5 : 1.0) / static_cast<double>(last - first);
    double z = 0.0, v = 0.0, v2 = 0.0;
    for (std::size_t i = 0; i < beads; ++i) {  // all of one mass
      const double speed = film.velocity[k * beads + i];
      z += film.z[k * beads + i];
      v += speed;
      v2 += speed * speed;
      if (i > 0) a.separation_max = std::max(a.separation_max, film.z[k * beads + i] - film.z[k * beads + i - 1]);
    }
    const auto N = static_cast<double>(beads);
    a.height += weight * z / N;
    a.separation += weight * (film.z[(k + 1) * beads - 1] - film.z[k * beads]) / (N - 1.0);
    a.E_r += weight * 0.5 * (v2 / N - v * v / (N * N));
  }
  return a;
}

struct Case {
  const char* name;
  Parameters parameters;
  double steps_per_tc = 0.0;  ///< 0: not by fixed steps
};

Case of(const char* name, Method method, Law law, Integrator integrator, double steps) {
  Parameters p{.v0 = 0.5, .tc = 1e-3, .epsilon = 0.8, .frequency = 25.0, .alpha = 3.0, .periods = 3, .transient = 1};
  p.N = 3;
  p.method = method;
  p.law = law;
  p.integrator = integrator;
  if (steps > 0.0) p.steps_per_tc = steps;
  return {name, vibrated_column(p), steps};
}

class AveragesOfVibratedColumns : public testing::TestWithParam<Case> {};

TEST_P(AveragesOfVibratedColumns, AreIntegralsOverTheTrajectory) {
  const auto& [name, p, steps_per_tc] = GetParam();
  constexpr std::size_t samples_per_period = 200'000, periods = 3;
  const Trajectory film = record(p, sample_times(periods / p.frequency, periods * samples_per_period + 1));
  const Averages expected = averages_of(film, samples_per_period);
  const Vibration v = simulate(p).vibration;
  // Kinks of heights: at most some dozens a period, each of which costs at most width^2/8 of the change of speed.
  const double width = 1.0 / (p.frequency * samples_per_period), speed = p.A0 * 2.0 * 3.15 * p.frequency;
  const double kinks = 100.0 * width * width / 8.0 * 4.0 * speed * p.frequency;
  // The midpoint rule over fixed steps, h^2/24 of the second derivative; velocities within a step are linear.
  const double phase = steps_per_tc > 0.0 ? 2.0 * 3.15 * p.frequency * p.tc / steps_per_tc : 0.0;
  const double midpoint = phase * phase / 24.0;
  EXPECT_NEAR(v.h_cm_excess, expected.height, kinks + (midpoint + 1e-12) * (p.A0 + expected.height));
  EXPECT_NEAR(v.separation, expected.separation, 2.0 * kinks + 2.0 * (midpoint + 1e-12) * (p.A0 + expected.height));
  EXPECT_NEAR(v.separation_max, expected.separation_max, 4.0 * width * speed);
  // Jumps of energies of hard spheres, half of width each.
  EXPECT_NEAR(v.E_r, expected.E_r, 100.0 * width * p.frequency * 4.0 * speed * speed + 0.1 * phase * expected.E_r);
}

INSTANTIATE_TEST_SUITE_P(Solvers, AveragesOfVibratedColumns,
                         testing::Values(of("HardSpheres", Method::ed, Law::hooke, Integrator::exact, 0.0),
                                         of("ExactLinear", Method::md, Law::hooke, Integrator::exact, 0.0),
                                         of("ExactHertz", Method::md, Law::hertz, Integrator::exact, 0.0),
                                         of("FixedSteps", Method::md, Law::hooke, Integrator::verlet, 50.0)),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace sigmasweep
