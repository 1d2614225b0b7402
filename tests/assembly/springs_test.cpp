#include "assembly/springs.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "assembly/diameters.hpp"
#include "base/random.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/names.hpp"
#include "support/parameters.hpp"

using namespace sigmasweep;

TEST(Springs, OfTheLinearLawOscillateWithContactTimeAndRestitution) {
  Parameters p;
  p.tc = 2e-5;
  p.epsilon = 0.9;
  const Parameters used = with_springs(p);
  const double frequency = std::sqrt(used.K_over_m - used.D_n * used.D_n);  // Eqs. (6), (7)
  EXPECT_NEAR(std::numbers::pi / frequency / p.tc, 1.0, 1e-14);
  EXPECT_NEAR(std::exp(-used.D_n * p.tc), 0.9, 1e-15);
}

TEST(Springs, GiveTheContactTimeAndRestitutionThatTheyAreFrom) {
  for (const Law law : {Law::hooke, Law::hertz, Law::hertz_kuwabara_kono, Law::taguchi, Law::cone}) {
    Parameters p;
    p.law = law;
    p.v0 = 0.3;
    p.tc = 2e-5;
    p.epsilon = 0.8;
    const Parameters back = completed(with_springs(p));
    EXPECT_NEAR(back.tc / p.tc, 1.0, 1e-12) << name_of(law);
    EXPECT_NEAR(back.epsilon, 0.8, 1e-10) << name_of(law);  // damping() has its errors below 1e-11
  }
}

TEST(Springs, StayAsTheyAreGivenAndHardSpheresHaveNone) {
  Parameters p;
  p.K_over_m = 2e9;
  p.D_n = 3.0;
  EXPECT_EQ(with_springs(p).K_over_m, 2e9);
  EXPECT_EQ(with_springs(p).D_n, 3.0);
  Parameters hard;
  hard.method = Method::ed;
  EXPECT_EQ(with_springs(hard).K_over_m, 0.0);
}

TEST(Diameters, AreUniformByTheSeed) {
  Parameters p;
  p.N = 4;
  EXPECT_TRUE(diameters(p).empty());
  p.d = 2e-3;
  p.width = 1e-3;
  p.seed = 9007199254740993;  // beyond the whole numbers of doubles
  const std::vector<double> all = diameters(p);
  ASSERT_EQ(all.size(), 4u);
  for (std::uint64_t i = 0; i < 4; ++i)
    EXPECT_NEAR(all[i], 2e-3 + 1e-3 * (unit_interval(random_bits(stream_key(9007199254740993, "diameter"), i)) - 0.5),
                1e-18);
}
