#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sigmasweep/model/names.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "support/parameters.hpp"

/// The largest restitution at which a touching column collapses.
namespace sigmasweep {
namespace {

struct Threshold {
  std::int64_t N;
  double matched, paper;  ///< by scans in 100 digits; N = 2 and 3 matched: 3 - 2 sqrt 2 and 1/3
};

// For N >= 4 collapse comes in windows, the last of which a scan may miss: hence some digits only.
constexpr Threshold thresholds[] = {{2, 0.1715729, 0.1116744}, {3, 0.3333333, 0.2958198}, {4, 0.45302, 0.42341},
                                    {5, 0.53253, 0.51186},     {6, 0.59266, 0.57580},     {8, 0.67375, 0.66440},
                                    {10, 0.72532, 0.71875}};

/// With speeds followed down to 1e-290 instead of 1e-16.
bool collapses_in_the_end(std::int64_t N, double epsilon, Wall wall) {
  const auto column = reduced_column<double>(hard_column({.epsilon = epsilon, .N = N, .wall = wall}));
  const HardSphereSettings settings{.predict_collapse = false, .collapsed_speed = 1e-290};
  return hard_sphere_collision(column, settings, {.settle = 0.0}).status == Status::collapsed;
}

bool collapses(std::int64_t N, double epsilon, Wall wall) {
  return simulate_hard_spheres(hard_column({.epsilon = epsilon, .N = N, .wall = wall})).status == Status::collapsed;
}

/// Where collapse ends, between a restitution at which there is and one at which there is none.
template <class Collapses>
double bisected(Collapses collapses, std::int64_t N, double below, double above, Wall wall) {
  while (above - below > 1e-7) {
    const double middle = 0.5 * (below + above);
    (collapses(N, middle, wall) ? below : above) = middle;
  }
  return below;
}

TEST(CollapseBisected, ComesToTheThreshold) {
  for (const Threshold& t : thresholds)
    for (const Wall wall : {Wall::matched, Wall::paper}) {
      SCOPED_TRACE(testing::Message() << "N=" << t.N << " " << name_of(wall));
      const double expected = wall == Wall::matched ? t.matched : t.paper;
      ASSERT_TRUE(collapses(t.N, 0.9 * expected, wall));
      ASSERT_FALSE(collapses(t.N, 1.1 * expected, wall));
      // Speeds below 1e-16 count as none. At N = 2 they fall to eps^(pi/sqrt(2.8 x)) before the beads part a fraction x
      // above the threshold, to 1e-16 at x = 0.8 %; with more beads windows add to that.
      EXPECT_NEAR(bisected(collapses, t.N, 0.9 * expected, 1.1 * expected, wall), expected, 0.013 * expected);
    }
}

// Closed forms for the matched wall, 100 digits for the paper's. A fraction x above the threshold speeds fall to
// eps^(pi/sqrt(2.8 x)) before two beads part: to 1e-290 at x = 2e-5.
TEST(CollapseBisected, TwoAndThreeBeads) {
  EXPECT_NEAR(bisected(collapses_in_the_end, 2, 0.15, 0.2, Wall::matched), 3.0 - 2.0 * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(bisected(collapses_in_the_end, 3, 0.3, 0.36, Wall::matched), 1.0 / 3.0, 5e-5);
  EXPECT_NEAR(bisected(collapses_in_the_end, 2, 0.1, 0.12, Wall::paper), 0.1116744346, 1e-5);
}

SimulationResult falling(std::int64_t N, double epsilon, Wall wall) {
  return simulate_hard_spheres(hard_column({.s0 = 1e-5, .epsilon = epsilon, .N = N, .wall = wall}));
}

// With gaps no energy is left long before the collisions come thick and fast, or stop: which of the two it is, the
// status says, and no row is left undecided.
TEST(BesideTheThreshold, ColumnsWithGapsCollapseOrPart) {
  struct Beside {
    std::int64_t N;
    Wall wall;
    double threshold;
  };
  for (const Beside& t : {Beside{2, Wall::matched, 3.0 - 2.0 * std::sqrt(2.0)}, Beside{2, Wall::paper, 0.1116744346},
                          Beside{3, Wall::matched, 1.0 / 3.0}, Beside{3, Wall::paper, 0.2958198}})
    for (const double share : {1e-5, 1e-4, 1e-3, 0.01, 0.02}) {
      SCOPED_TRACE(testing::Message() << "N=" << t.N << " " << name_of(t.wall) << " " << share);
      EXPECT_EQ(falling(t.N, (1.0 - share) * t.threshold, t.wall).status, Status::collapsed);
      const SimulationResult above = falling(t.N, (1.0 + share) * t.threshold, t.wall);
      EXPECT_EQ(above.status, Status::ok);
      EXPECT_EQ(above.end, End::separated);
    }
  EXPECT_EQ(falling(3, 0.29537662798581454, Wall::paper).status, Status::collapsed);
}

// Numbers of collisions by arithmetic of 1200 digits, collision by collision. Four beads part in windows below the last
// threshold, too.
TEST(BesideTheThreshold, AllCollisionsAreCounted) {
  struct Counted {
    std::int64_t N;
    double epsilon;
    Wall wall;
    std::uint64_t collisions;
  };
  for (const Counted& c :
       {Counted{2, 0.1116744346 * 1.0001, Wall::paper, 432}, Counted{3, 0.29581982 * 1.0005, Wall::paper, 374},
        Counted{4, 0.45302 * 0.999, Wall::matched, 2173}, Counted{4, 0.45302 * 1.0015, Wall::matched, 1675},
        Counted{4, 0.42341 * 0.998, Wall::paper, 952}, Counted{4, 0.42341 * 1.00001, Wall::paper, 421}}) {
    const SimulationResult result = falling(c.N, c.epsilon, c.wall);
    EXPECT_EQ(result.status, Status::ok) << c.N << " " << c.epsilon;
    EXPECT_EQ(result.end, End::separated);
    EXPECT_EQ(result.contacts, c.collisions) << c.N << " " << c.epsilon;
  }
  EXPECT_EQ(falling(4, 0.45302 * 0.9995, Wall::matched).status, Status::collapsed);
}

// A fraction x above the threshold of two beads, the number of collisions is that of half a turn of the complex
// eigenvalues of a cycle, which is proportional to 1/sqrt(x).
TEST(BesideTheThreshold, CollisionsGrowWithoutBound) {
  const double threshold = 3.0 - 2.0 * std::sqrt(2.0);
  const auto collisions = [&](double x) {
    return static_cast<double>(falling(2, threshold * (1.0 + x), Wall::matched).contacts);
  };
  for (const double x : {0.01, 0.003, 0.001}) EXPECT_NEAR(collisions(x / 4.0) / collisions(x), 2.0, 0.1) << x;
}

}  // namespace
}  // namespace sigmasweep
