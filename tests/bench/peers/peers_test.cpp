// The peers compute the same collisions: a comparison with a peer that does not would say nothing.
#include <gtest/gtest.h>

#include "bench/peers/odeint_events.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"

namespace sigmasweep::peers {
namespace {

TEST(OdeintWithEvents, AgreesWithTheExactSolver) {
  for (const double sigma : {0.0, 0.3, 2.0}) {
    const double exact = simulate(soft_column(beads, epsilon, sigma)).eps_eff;
    EXPECT_NEAR(odeint_with_events(sigma, 1e-11).eps_eff, exact, 1e-9) << "sigma = " << sigma;
  }
}

}  // namespace
}  // namespace sigmasweep::peers
