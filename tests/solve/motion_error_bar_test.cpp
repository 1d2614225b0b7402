// Are Er_Ef and v_cm as good as their error bars say? They depend on all velocities, which late contacts of next to no
// energy still change when eps_eff is done: a loss of E_f by 1e-8 may change velocities by 1e-4.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "assembly/energies.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "support/error_bars.hpp"
#include "support/parameters.hpp"
#include "support/random.hpp"

namespace {

using namespace sigmasweep;

struct Motion {
  double Er_Ef, v_cm;
};

Parameters random_parameters(Random& uniform, int most_beads) {
  Parameters p;
  p.N = 2 + std::int64_t((most_beads - 1) * uniform());
  p.epsilon = uniform() < 0.1 ? 1.0 : 0.2 + 0.8 * uniform();
  p.sigma = uniform() < 0.1 ? 0.0 : std::pow(10.0, -3.0 + 4.0 * uniform());
  if (uniform() < 0.3) p.width = p.d * std::pow(10.0, -4.0 + 4.0 * uniform());
  p.seed = std::int64_t(1e6 * uniform());
  p.wall = uniform() < 0.5 ? Wall::matched : Wall::paper;
  return completed(p);
}

std::optional<Motion> motion_of(const Column<long double>& column, const Outcome<long double>& outcome) {
  if (outcome.status != Status::ok) return {};
  const auto e = energies<long double>(outcome.velocity, 1.0L, column.mass);
  return Motion{double(e.Er_Ef), double(e.v_cm)};
}

/// To the very end.
std::optional<Motion> true_motion(const Parameters& p) {
  if (p.method == Method::ed) {
    Parameters finer = p;
    finer.tolerance = 1e-15;
    const SimulationResult c = simulate(finer);
    if (c.end != End::separated || c.status == Status::collapsed) return {};
    return Motion{c.Er_Ef, c.v_cm};
  }
  const auto column = reduced_column<long double>(p);
  if (p.law == Law::hooke) return motion_of(column, exact_collision(column, RunLimits{.settle = 0.0}));
  return motion_of(column, nonlinear_collision(column, 1e-15, RunLimits{.settle = 1e-22}));
}

/// Er_Ef and v_cm of doubles have roundings of their own.
void see(const Parameters& p, ErrorBars& bars) {
  const SimulationResult c = simulate(p);
  const auto known = is_success(c.status) ? true_motion(p) : std::nullopt;
  if (!known) return;
  bars.see(std::fmax(std::fabs(c.Er_Ef - known->Er_Ef) - 1e-17, 0.0), c.Er_Ef_error);
  bars.see(std::fmax(std::fabs(c.v_cm - known->v_cm) - 1e-16, 0.0), c.v_cm_error);
}

TEST(MotionErrorBar, HoldsForTheLinearLaw) {
  for (const double tolerance : {1e-4, 1e-10}) {
    Random uniform(1);
    ErrorBars bars;
    for (int i = 0; i < 300; ++i) {
      Parameters p = random_parameters(uniform, 16);
      p.tolerance = tolerance;
      see(p, bars);
    }
    bars.expect_true(550);
    bars.expect_useful(tolerance < 1e-5 ? 300.0 : 3e4);  // loose: where settled, by what late contacts might do
  }
}

TEST(MotionErrorBar, HoldsForOtherLaws) {
  Random uniform(2);
  ErrorBars bars;
  for (int i = 0; i < 40; ++i) {
    Parameters p = random_parameters(uniform, 10);
    p.law = i % 2 ? Law::taguchi : Law::hertz;
    p.tolerance = 1e-5;
    see(completed(p), bars);
  }
  bars.expect_true(70);
}

TEST(MotionErrorBar, HoldsForHardSpheres) {
  Random uniform(3);
  ErrorBars bars;
  for (int i = 0; i < 200; ++i) {
    Parameters p = random_parameters(uniform, 8);
    p.epsilon = 0.7 + 0.3 * uniform();  // few collapses
    p.method = Method::ed;
    see(p, bars);
  }
  bars.expect_true(350);
  bars.expect_useful(300.0);
}

// Steps of the paper's length: the error is the distance to the exact result.
TEST(MotionErrorBar, HoldsForFixedSteps) {
  Random uniform(4);
  ErrorBars bars;
  for (int i = 0; i < 60; ++i) {
    Parameters p = random_parameters(uniform, 10);
    p.integrator = Integrator::verlet;
    p.steps_per_tc = 50.0;
    see(p, bars);
  }
  bars.expect_true(80);
}

// At the end of a long tail of contacts eps_eff is off by 1.5e-6, the share of the relative motion by 4e-4.
TEST(MotionErrorBar, KnowsThatTheRelativeMotionIsLessCertain) {
  Parameters p = soft_column(12, 0.7, 20.0);
  p.law = Law::taguchi;
  p.tolerance = 1e-5;
  p = completed(p);
  const SimulationResult c = simulate(p);
  ASSERT_EQ(c.status, Status::ok);
  EXPECT_LE(c.eps_eff_error, p.tolerance);
  EXPECT_GT(c.Er_Ef_error, 1e-4);
  ErrorBars bars;
  see(p, bars);
  bars.expect_true(2);
}

}  // namespace
