#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "assembly/column.hpp"
#include "base/quad.hpp"
#include "sigmasweep/model/names.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "solve/hard_spheres/plain_hard_spheres.hpp"
#include "support/error_bars.hpp"
#include "support/parameters.hpp"
#include "support/random.hpp"

/// Is the error bar of hard spheres true?
namespace sigmasweep {
namespace {

using plain_hard_spheres::Plain, plain_hard_spheres::Wide;

Parameters random_tuple(Random& uniform) {
  Parameters p;
  p.method = Method::ed;
  p.N = static_cast<std::int64_t>(uniform(1.0, 13.0));
  p.epsilon = uniform(0.0, 1.0) < 0.1 ? 1.0 : uniform(0.05, 1.0);
  p.wall = uniform(0.0, 1.0) < 0.5 ? Wall::paper : Wall::matched;
  p.ed_rule = uniform(0.0, 1.0) < 0.4 ? EdRule::tc : EdRule::lrv;
  p.sigma = uniform(0.0, 1.0) < 0.15 ? 0.0 : std::pow(10.0, uniform(-2.0, 2.5));
  if (uniform(0.0, 1.0) < 0.6) p.width = p.d * uniform(0.05, 1.8);
  if (uniform(0.0, 1.0) < 0.6) p.random_separation = Flag::yes;
  p.seed = static_cast<std::int64_t>(uniform.bits() >> 1);
  return completed(p);
}

TEST(HardSpheresErrorBar, HoldsForRandomColumns) {
  Random random(20240918);
  ErrorBars bars;
  for (int i = 0; i < 400; ++i) {
    const Parameters p = random_tuple(random);
    const SimulationResult c = simulate_hard_spheres(p);
    ASSERT_TRUE(is_success(c.status) || c.status == Status::tolerance_missed) << name_of(c.status);
    ASSERT_EQ(is_success(c.status), c.eps_eff_error <= p.tolerance);
    if (p.ed_rule == EdRule::tc) {
      EXPECT_NE(c.status, Status::collapsed);
    }
    const auto column = reduced_column<Quad>(p);
    Plain plain(column, p.ed_rule);
    if (!is_success(c.status) || !plain.run(20'000)) continue;  // long collapses take the plain program minutes
    const double error = std::fabs(static_cast<double>(Wide(c.eps_eff) - plain.eps_eff(Wide(column.speed))));
    bars.see(error, c.eps_eff_error);
  }
  // Columns near the threshold of collapse may come apart again below the resolution of the clock: 1 of 1000.
  bars.expect_true(300);
}

}  // namespace
}  // namespace sigmasweep
