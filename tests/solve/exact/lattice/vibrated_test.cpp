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
