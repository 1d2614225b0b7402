#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "support/parameters.hpp"

/// Lattices in a vibrated container, from event to event.
namespace sigmasweep {
namespace {

Parameters parameters(std::int64_t rows, std::int64_t columns, double tc) {
  return vibrated_lattice({.tc = tc,
                           .s0 = 1e-4,
                           .epsilon = 0.8,
                           .frequency = 20.0,
                           .alpha = 3.0,
                           .periods = 6,
                           .transient = 1,
                           .rows = rows,
                           .columns = columns,
                           .seed = 1,
                           .side_walls = SideWalls::fixed,
                           .random_separation = Flag::yes});
}

/// One bead is a column of one.
TEST(VibratedLattice, OfOneBeadIsAColumnOfOne) {
  Parameters p = parameters(1, 1, 1e-4);
  p.periods = 12;
  p.random_separation = Flag::no;
  Parameters q = p;
  q.geometry = Geometry::vibrated_column;
  const SimulationResult column = simulate(q), same = simulate(p);
  ASSERT_EQ(column.status, Status::ok);
  ASSERT_EQ(same.status, Status::ok);
  // The lattice's mean is over moments, the column's is an integral.
  EXPECT_NEAR(same.vibration.h_cm_excess, column.vibration.h_cm_excess, 2e-8);
  EXPECT_LT(2e-8, same.vibration.h_cm_error);
  // Each contact has local errors of 1e-10 of the plate's speed, 0.23 m/s, which go on through up to 0.6 s; the column
  // is exact to rounding.
  const std::vector<double> times = sample_times(12 / p.frequency, 1201);
  const Trajectory of_column = record(q, times), of_same = record(p, times);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(of_same.z[k] - p.d / 2, of_column.z[k], 5e-11) << k;
  EXPECT_NEAR(same.vibration.power_in, column.vibration.power_in, 1e-6 * column.vibration.power_in);
  EXPECT_NEAR(same.x_max, column.x_max, 1e-6 * column.x_max);
  EXPECT_EQ(same.contacts, column.contacts);
}

/// What the plate gives is lost or kept.
TEST(VibratedLattice, KeepsItsBooks) {
  for (const double D_t : {0.0, 1e3})
    for (const Law law : {Law::hooke, Law::hertz}) {
      Parameters p = parameters(3, 4, 2e-4);
      p.D_t = D_t;
      p.law = law;
      p.width = 0.2 * p.d;
      const SimulationResult c = simulate(p);
      ASSERT_EQ(c.status, Status::ok);
      EXPECT_EQ(c.end, End::periods);
      EXPECT_GT(c.contacts, 20U);
      EXPECT_GT(c.vibration.power_lost, 0.0);
      EXPECT_LT(std::fabs(c.vibration.imbalance), 1e-7) << D_t;  // local errors of 1e-10, some thousand steps
    }
}

/// Beads that rest side by side without a gap and without a force neither open nor close: the number of contacts does
/// not go with the time over tc, and nothing is pumped into the lattice.
TEST(VibratedLattice, RestsWhereItsRowsHaveNoGaps) {
  const auto at_rest = [](std::int64_t columns, double tc, Law law) {
    return simulate(vibrated_lattice({.v0 = 0.1,
                                      .tc = tc,
                                      .s0 = 0.0,
                                      .epsilon = 0.9,
                                      .frequency = 20.0,
                                      .alpha = 0.5,
                                      .periods = 10,
                                      .transient = 2,
                                      .rows = 4,
                                      .columns = columns,
                                      .law = law}));
  };
  for (const Law law : {Law::hooke, Law::hertz})
    for (const double tc : {1e-3, 2e-4}) {
      // Rows whose beads do not press on each other move alike: two columns are as good as many.
      const SimulationResult many = at_rest(4, tc, law), two = at_rest(2, tc, law);
      ASSERT_EQ(many.status, Status::ok);
      ASSERT_EQ(two.status, Status::ok);
      EXPECT_LT(many.contacts, 500U) << tc;
      EXPECT_LT(std::fabs(many.vibration.imbalance), 1e-12) << tc;
      EXPECT_NEAR(many.vibration.h_cm, two.vibration.h_cm, 1e-9 * two.vibration.h_cm) << tc;
      EXPECT_NEAR(many.x_max, two.x_max, 1e-6 * two.x_max) << tc;
      EXPECT_NEAR(many.vibration.power_lost, two.vibration.power_lost, 1e-5 * two.vibration.power_lost) << tc;
    }
}

/// The first period, before chaos: small fixed steps see the same.
TEST(VibratedLattice, MovesAsSmallFixedStepsSay) {
  Parameters p = parameters(3, 2, 5e-4);
  p.periods = 1;
  p.transient = 0;
  const SimulationResult exact = simulate(p);
  p.integrator = Integrator::rk4;
  p.steps_per_tc = 4000.0;
  const SimulationResult steps = simulate(p);
  ASSERT_EQ(exact.status, Status::ok);
  ASSERT_EQ(steps.status, Status::ok);
  EXPECT_NEAR(steps.vibration.h_cm, exact.vibration.h_cm, 1e-4 * p.d);
  EXPECT_NEAR(steps.vibration.power_in, exact.vibration.power_in, 1e-2 * exact.vibration.power_in);
}

}  // namespace
}  // namespace sigmasweep
