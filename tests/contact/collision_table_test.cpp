#include "contact/collision_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "sigmasweep/contact/pair_collision.hpp"

/// Collisions by interpolation are those that are integrated.
namespace sigmasweep {
namespace {

TEST(CollisionTable, IsTheIntegratedCollision) {
  int found = 0;
  for (const auto& [beta, gamma] :
       {std::pair{0.5, 0.0}, {0.5, 0.25}, {0.5, 0.5}, {0.842, 0.646}, {0.2, 0.7}, {1.0, 0.0}}) {
    const Exponents e{beta, gamma};
    const auto table = CollisionTable::of(e);
    ASSERT_TRUE(table) << beta << ' ' << gamma;
    for (const double b : {1e-6, 0.01, 0.3, 2.0})
      for (const double v : {1e-7, 3e-4, 0.02, 1.0, 37.0}) {
        const PairLaw law{e, 7.3, b};
        const auto c = table->collide(law, v);
        if (!c) continue;
        ++found;
        const PairCollision integrated = collide(law, v);
        // Its own error is of the same size.
        EXPECT_NEAR(c->eps, integrated.eps, 2.0 * CollisionTable::accuracy * integrated.eps)
            << beta << ' ' << b << ' ' << v;
        EXPECT_NEAR(c->duration, integrated.duration, 2.0 * CollisionTable::accuracy * integrated.duration) << b;
        EXPECT_NEAR(c->x_max, integrated.x_max, 2.0 * CollisionTable::accuracy * integrated.x_max) << b;
      }
  }
  EXPECT_GT(found, 60);
}

TEST(CollisionTable, EndsWhereLossesAreStrong) {
  const auto table = CollisionTable::of({0.5, 0.0});
  ASSERT_TRUE(table);
  EXPECT_FALSE(table->collide({{0.5, 0.0}, 1.0, 50.0}, 1.0));
  EXPECT_TRUE(table->collide({{0.5, 0.0}, 1.0, 0.0}, 1.0));
}

}  // namespace
}  // namespace sigmasweep
