#include "solve/hard_spheres/collision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solve/hard_spheres/cluster.hpp"

namespace sigmasweep {
namespace {

Column<double> column(std::int64_t N, double eps, double eps_wall, double gap, double speed = 1.0) {
  Column<double> c;
  c.N = N;
  c.gap = gap;
  c.speed = speed;
  c.tc = 1.0;
  c.eps = eps;
  c.eps_wall = eps_wall;
  return c;
}

TEST(HardSpheres, OneBeadBouncesOnce) {
  const auto o = hard_sphere_collision(column(1, 0.9, 0.7, 2.0, 3.0));
  ASSERT_EQ(o.velocity.size(), 1u);
  EXPECT_DOUBLE_EQ(o.velocity[0], 2.1);
  EXPECT_EQ(o.contacts, 1u);
  EXPECT_EQ(o.t_k, 0.0);
  EXPECT_EQ(o.status, Status::ok);
  EXPECT_EQ(o.end, End::separated);
}

TEST(HardSpheres, TwoBeadsByHand) {
  // GapParameter 1, speed 1, eps = eps_wall = 1/2. At 1 bead 1 bounces: v = (1/2, -1), the gap 1 closes at 3/2, 2/3
  // later. Then v1 = 1/2 - 9/8 = -5/8, v2 = -1 + 9/8 = 1/8; bead 1 is at height 1/3 and falls at 5/8: wall after 8/15,
  // where v1 = 5/16 > v2, 3/16 faster. Bead 2 is 2/5 ahead (3/4 of 8/15): 32/15 later they meet: v1 = 5/16 - 9/64 =
  // 11/64, v2 = 1/8 + 9/64 = 17/64. Over, after 4 collisions.
  const auto o = hard_sphere_collision(column(2, 0.5, 0.5, 1.0));
  ASSERT_EQ(o.velocity.size(), 2u);
  EXPECT_NEAR(o.velocity[0], 11.0 / 64, 1e-15);
  EXPECT_NEAR(o.velocity[1], 17.0 / 64, 1e-15);
  EXPECT_EQ(o.contacts, 4u);
  EXPECT_NEAR(o.t_k, 2.0 / 3 + 8.0 / 15, 1e-14);
}

TEST(HardSpheres, GapAndSpeedOnlyScaleTheResult) {
  const auto a = hard_sphere_collision(column(7, 0.85, 0.9, 1.0));
  const auto b = hard_sphere_collision(column(7, 0.85, 0.9, 1e-12, 1e3));
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(a.velocity[k] * 1e3, b.velocity[k]);
  EXPECT_NEAR(a.t_k * 1e-15, b.t_k, 1e-30);
  EXPECT_EQ(a.contacts, b.contacts);
}

TEST(HardSpheres, ElasticTouchingBeadsTurnRoundAsOne) {
  const auto o = hard_sphere_collision(column(6, 1.0, 1.0, 0.0));
  for (const double v : o.velocity) EXPECT_EQ(v, 1.0);
  EXPECT_EQ(o.contacts, 21u);
  EXPECT_EQ(o.t_k, 0.0);
}

TEST(HardSpheres, GivesUpAtTheCollisionLimit) {
  const auto o = hard_sphere_collision(column(10, 0.9, 0.9, 1.0), {}, {.event_limit = 20});
  EXPECT_EQ(o.status, Status::event_limit);
  EXPECT_EQ(o.contacts, 20u);
}

TEST(Clusters, APairMovesOnWithItsMean) {
  const std::vector<double> u{0.5};
  const Cluster free = cluster_around(0, u, false);
  EXPECT_EQ(free.beads, 2u);
  EXPECT_DOUBLE_EQ(free.bottom_change, -0.25);
  EXPECT_DOUBLE_EQ(free.top_change, 0.25);
  EXPECT_DOUBLE_EQ(free.least_impulse, 0.25);
  const Cluster wall = cluster_around(0, u, true);
  EXPECT_TRUE(wall.wall);
  EXPECT_EQ(wall.bottom_change, 0.0);
  EXPECT_DOUBLE_EQ(wall.top_change, 0.5);
}

TEST(Clusters, EndWhereBeadsPart) {
  // Velocities 0, -1, -1, 3, 2.5 from the lowest bead on: the pair at the top leaves the three below.
  const std::vector<double> u{1.0, 0.0, -4.0, 0.5};
  const Cluster below = cluster_around(0, u, false);
  EXPECT_EQ(below.first, 0u);
  EXPECT_EQ(below.beads, 3u);
  EXPECT_NEAR(below.top_change, 1.0 / 3, 1e-15);
  EXPECT_NEAR(below.parting, 2.75 + 2.0 / 3, 1e-15);
  const Cluster above = cluster_around(3, u, false);
  EXPECT_EQ(above.first, 3u);
  EXPECT_EQ(above.beads, 2u);
}

TEST(Clusters, CollapseIsNotForetoldForFewOrElasticBeads) {
  std::vector<double> u(30, 1e-3);
  EXPECT_TRUE(will_collapse(cluster_around(0, u, true), 0.5));
  EXPECT_FALSE(will_collapse(cluster_around(0, u, true), 0.99));
  EXPECT_FALSE(will_collapse(cluster_around(0, std::vector<double>(2, 1e-3), true), 0.5));
}

}  // namespace
}  // namespace sigmasweep
