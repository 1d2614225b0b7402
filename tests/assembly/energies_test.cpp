#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "assembly/energies.hpp"
#include "support/random.hpp"

namespace {

using namespace sigmasweep;
using Velocities = std::vector<double>;

TEST(Energies, OfThreeBeads) {
  const Velocities v{0.2, 0.4, 0.6};  // in units of a speed of 2: 0.1, 0.2, 0.3
  const auto e = energies<double>(v, 2.0);
  EXPECT_NEAR(e.v_cm, 0.2, 1e-16);
  EXPECT_NEAR(e.eps_eff, std::sqrt(0.14 / 3.0), 1e-16);
  EXPECT_NEAR(e.Er_E0, 0.02 / 3.0, 1e-17);
  EXPECT_NEAR(e.Er_Ef, 0.02 / 0.14, 1e-15);
}

TEST(Energies, KeepTheirDigitsWhenTheBeadsHardlyMoveApart) {
  const auto e = energies<double>(Velocities{1.0, 1.0 + 1e-9}, 1.0);
  EXPECT_NEAR(e.Er_E0, 0.25e-18, 1e-24);  // the difference of 1 + 1e-9 and 1 is good to 1e-16
}

TEST(ResidualDissipation, OfSmallColumns) {
  EXPECT_EQ(residual_dissipation<double>(Velocities{0.5, 1.0}, 1.0), 0.0) << "nothing approaches";
  EXPECT_NEAR(residual_dissipation<double>(Velocities{-1.0}, 1.0), 1.0, 1e-15) << "a dead wall stops the bead";
  EXPECT_NEAR(residual_dissipation<double>(Velocities{1.0, -1.0}, 1.0), 1.0, 1e-15) << "two that stop each other";
  // 1, 0 -> 1/2, 1/2: sqrt(1/2) - 1/2
  EXPECT_NEAR(residual_dissipation<double>(Velocities{1.0, 0.0}, 1.0), std::sqrt(0.5) - 0.5, 1e-15);
  EXPECT_NEAR(residual_dissipation<double>(Velocities{3.0, 0.0}, 3.0), std::sqrt(0.5) - 0.5, 1e-15) << "in units of v0";
}

// Whatever the restitutions and the order of the collisions, no column loses more than the bound says.
TEST(ResidualDissipation, BoundsEverySequenceOfCollisions) {
  Random uniform(7);
  for (int trial = 0; trial < 2000; ++trial) {
    Velocities v(1 + uniform.bits() % 8);
    for (double& vi : v) vi = 2.0 * uniform() - 1.0;
    const double start = energies<double>(v, 1.0).eps_eff, bound = residual_dissipation<double>(v, 1.0);
    for (int collision = 0; collision < 500; ++collision) {
      const std::size_t k = uniform.bits() % v.size();
      const double eps = trial % 3 == 0 ? 0.0 : uniform();
      if (k == 0) {
        if (v[0] < 0) v[0] *= -eps;
      } else if (const double approach = v[k - 1] - v[k]; approach > 0) {
        v[k - 1] -= (1.0 + eps) / 2.0 * approach;
        v[k] += (1.0 + eps) / 2.0 * approach;
      }
    }
    // 500 collisions of a few roundings, relative to eps_eff > 1e-4.
    EXPECT_GE(energies<double>(v, 1.0).eps_eff, start - bound - 1e-12) << "trial " << trial;
  }
}

}  // namespace
