// Contacts that just touch, or just stay closed: as sigma changes by its last digit a contact comes or goes, and
// nothing else may.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

struct Family {
  std::int64_t N;
  double epsilon;
  Law law = Law::hooke;
  double width = 0.0;

  Parameters at(double sigma) const {
    return soft_column({.sigma = sigma, .epsilon = epsilon, .width = width * Parameters{}.d, .N = N, .law = law});
  }
};

struct Grazing {
  double low, high;  ///< of sigma: neighbouring doubles, or nearly, with different numbers of contacts
};

/// Bisects the number of contacts between two values of sigma at which it differs.
Grazing grazing_between(const Family& family, double low, double high) {
  const std::uint64_t few = simulate(family.at(low)).contacts;
  while (high - low > 4e-16 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (simulate(family.at(middle)).contacts == few ? low : high) = middle;
  }
  return {low, high};
}

/// How many grazing contacts there are between sigma = 0 and 3; at each eps_eff must be continuous, within what the two
/// error bars say.
int expect_continuity(const Family& family, int places) {
  int found = 0;
  const double step = 3.0 / places;
  for (int i = 0; i < places; ++i) {
    const double low = step * i, high = step * (i + 1);
    if (simulate(family.at(low)).contacts == simulate(family.at(high)).contacts) continue;
    const Grazing grazing = grazing_between(family, low, high);
    const SimulationResult a = simulate(family.at(grazing.low)), b = simulate(family.at(grazing.high));
    if (a.status != Status::ok || b.status != Status::ok) continue;
    ++found;
    SCOPED_TRACE(testing::Message() << "N " << family.N << " eps " << family.epsilon << " law " << int(family.law)
                                    << " sigma " << std::hexfloat << grazing.low);
    EXPECT_NEAR(a.eps_eff, b.eps_eff, a.eps_eff_error + b.eps_eff_error);
    EXPECT_LE(a.eps_eff_error + b.eps_eff_error, 2e-10);
  }
  return found;
}

TEST(Grazing, ChangesNothingInColumnsOfEqualBeads) {
  int found = 0;
  for (const std::int64_t N : {2, 3, 5, 10})
    for (const double epsilon : {1.0, 0.9, 0.5, 0.1}) found += expect_continuity({N, epsilon}, 30);
  EXPECT_GE(found, 50);
}

TEST(Grazing, ChangesNothingInColumnsOfUnequalBeads) {
  int found = 0;
  for (const double width : {0.3, 1.9})
    for (const double epsilon : {1.0, 0.9, 0.5}) found += expect_continuity({6, epsilon, Law::hooke, width}, 30);
  EXPECT_GE(found, 20);
}

TEST(Grazing, ChangesNothingWithOtherLaws) {
  int found = 0;
  for (const Law law : {Law::hertz, Law::hertz_kuwabara_kono})
    for (const double epsilon : {1.0, 0.9}) found += expect_continuity({4, epsilon, law}, 8);
  EXPECT_GE(found, 4);
}

// Touching beads, gaps too small for any number to see, and gaps of zero are one column; and the limit is reached in
// proportion to sigma. 10: the slope of eps_eff at sigma = 0 is some tenths.
TEST(Grazing, TouchingIsTheLimitOfSmallGaps) {
  for (const Law law : {Law::hooke, Law::hertz})
    for (const std::int64_t N : {2, 3, 10})
      for (const double epsilon : {1.0, 0.9, 0.5}) {
        const Family family{N, epsilon, law};
        const SimulationResult touching = simulate(family.at(0.0));
        for (const double sigma : {1e-300, 1e-30, 1e-18, 1e-16, 1e-12, 1e-8}) {
          const SimulationResult c = simulate(family.at(sigma));
          ASSERT_EQ(c.status, Status::ok);
          EXPECT_NEAR(c.eps_eff, touching.eps_eff, c.eps_eff_error + touching.eps_eff_error + 10.0 * sigma)
              << "N " << N << " eps " << epsilon << " law " << int(law) << " sigma " << sigma;
        }
      }
}

}  // namespace
