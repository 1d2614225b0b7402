#include "solve/exact/power_law/isolated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "assembly/energies.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "support/parameters.hpp"

/// Isolated contacts by a table, against columns all of whose contacts are integrated: those of an accuracy that the
/// table does not have.
namespace sigmasweep {
namespace {

constexpr double by_table = 1e-13, by_steps = 1e-14;  // local accuracies

TEST(IsolatedContacts, MoveColumnsAsStepsDo) {
  for (const Law law : {Law::hertz, Law::taguchi, Law::hertz_kuwabara_kono})
    for (const std::int64_t N : {1, 2, 3, 5, 8})
      for (const double sigma : {0.3, 0.8, 1.3, 2.2, 4.0, 30.0})
        for (const Wall wall : {Wall::paper, Wall::matched}) {
          const Parameters p = soft_column({.sigma = sigma, .epsilon = 0.85, .N = N, .wall = wall, .law = law});
          const Column<double> column = reduced_column<double>(p);
          const Outcome<double> table = nonlinear_collision(column, by_table),
                                steps = nonlinear_collision(column, by_steps);
          ASSERT_EQ(table.status, Status::ok);
          SCOPED_TRACE(testing::Message() << int(law) << " N " << N << " sigma " << sigma);
          EXPECT_EQ(table.contacts, steps.contacts);
          EXPECT_NEAR(energies<double>(table.velocity, 1.0, {}).eps_eff,
                      energies<double>(steps.velocity, 1.0, {}).eps_eff, 1e-9);
          EXPECT_NEAR(table.t_k, steps.t_k, 1e-8 * steps.t_k);
          EXPECT_NEAR(table.x_max, steps.x_max, 1e-10 * steps.x_max);
        }
}

TEST(IsolatedContacts, MoveUnequalBeadsAsStepsDo) {
  for (const double sigma : {1.0, 3.0, 20.0})
    for (const std::int64_t seed : {1, 2, 3}) {
      Parameters p = soft_column({.sigma = sigma, .epsilon = 0.9, .N = 6, .law = Law::hertz});
      p.width = 0.3 * p.d;
      p.random_separation = Flag::yes;
      p.seed = seed;
      const Column<double> column = reduced_column<double>(p);
      const Outcome<double> table = nonlinear_collision(column, by_table),
                            steps = nonlinear_collision(column, by_steps);
      EXPECT_EQ(table.contacts, steps.contacts);
      EXPECT_NEAR(energies<double>(table.velocity, 1.0, column.mass).eps_eff,
                  energies<double>(steps.velocity, 1.0, column.mass).eps_eff, 1e-9);
    }
}

/// Half-way through its collision a contact is where steps see it, and the beads beside it know as much.
TEST(IsolatedContacts, HaveTrueStatesHalfWay) {
  const Column<double> column =
      reduced_column<double>(soft_column({.epsilon = 0.9, .N = 1, .wall = Wall::matched, .law = Law::hertz}));
  IsolatedContacts isolated(column, 1e-13, 0.0);
  const ContactState<double> closing{1e-15, 1.0};
  const auto state = isolated.virtual_state(0, closing);
  ASSERT_TRUE(state);
  EXPECT_NEAR(-state->u, 0.9, 1e-12);  // that of a pair at v0
  isolated.begin(0, closing, 5.0);
  EXPECT_TRUE(isolated.is_busy(0));
  const double duration = state->x / -state->u;
  const ContactState<double> last = isolated.true_state(0, 5.0 + duration * (1.0 - 1e-9));
  EXPECT_NEAR(last.u, -0.9, 1e-8);
  EXPECT_NEAR(last.x, 0.9e-9 * duration, 1e-12);
  EXPECT_EQ(isolated.true_state(0, 5.0).u, 1.0);
  EXPECT_GT(isolated.end(0), 0.0);
  EXPECT_FALSE(isolated.any());
}

}  // namespace
}  // namespace sigmasweep
