#include "contact/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace sigmasweep {
namespace {

constexpr Exponents all[]{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.25}, {0.5, 0.5}, {1.0, 1.0}, {0.0, 0.2}, {0.37, 0.1}};

TEST(ContactLaw, EveryFormIsThePowerLawWithItsExponents) {
  for (const Exponents e : all)
    visit_law(e, [&](const auto& law) {
      for (const double x : {1e-9, 0.3, 1.0, 17.0})
        for (const double u : {-2.0, 0.0, 0.7}) {
          const double spring = 3.0 * std::pow(x, 1.0 + e.beta), dashpot = 0.2 * std::pow(x, e.gamma) * u;
          // Some roundings of powers and square roots.
          EXPECT_NEAR(law(3.0, 0.2, x, u), spring + dashpot, 1e-14 * (spring + std::fabs(dashpot)));
          EXPECT_NEAR(law.twice_elastic_energy(3.0, x) / (6.0 * std::pow(x, 2.0 + e.beta) / (2.0 + e.beta)), 1.0,
                      1e-14);
        }
    });
}

/// The force without losses is the derivative of the energy, and the dashpot's potential that of its force over u.
TEST(ContactLaw, ForcesAreDerivativesOfThePotentials) {
  constexpr double x = 0.8, h = 1e-5;  // the error of the central difference is of the order of h^2
  for (const Exponents e : all) {
    const auto slope = [&](auto potential) { return (potential(x + h) - potential(x - h)) / (2.0 * h); };
    visit_law(e, [&](const auto& law) {
      EXPECT_NEAR(slope([&](double y) { return 0.5 * twice_elastic_energy(e, 3.0, y); }), law(3.0, 0.0, x, 0.0), 1e-8);
      EXPECT_NEAR(slope([&](double y) { return dashpot_potential(e, 0.2, y); }), law(0.0, 0.2, x, 1.0), 1e-8);
      EXPECT_NEAR(slope([&](double y) { return law(1.0, 0.0, y, 0.0); }), tangent(e, x).spring, 1e-8);
      EXPECT_NEAR(law(0.0, 1.0, x, 1.0), tangent(e, x).dashpot, 1e-14);
    });
  }
}

TEST(ContactLaw, LinearExponentsHaveTheLinearLaw) {
  visit_law(Exponents{},
            [](const auto& law) { EXPECT_TRUE((std::is_same_v<std::decay_t<decltype(law)>, LinearLaw>)); });
  visit_law(NonlinearLaws{}, Exponents{},
            [](const auto& law) { EXPECT_TRUE((std::is_same_v<std::decay_t<decltype(law)>, PowerLaw>)); });
}

TEST(ContactLaw, AnOpenContactHasNoForce) {
  for (const Exponents e : all)
    visit_law(e, [](const auto& law) {
      for (const double x : {-1.0, 0.0}) EXPECT_EQ(where_closed(law, 3.0, 0.2, x, -1.0), 0.0);
    });
}

TEST(ContactLaw, TheClockExponentMakesAllPowersWhole) {
  EXPECT_EQ(clock_exponent({0.0, 0.0}), 1);
  EXPECT_EQ(clock_exponent({0.5, 0.0}), 2);
  EXPECT_EQ(clock_exponent({0.5, 0.25}), 4);
  EXPECT_EQ(clock_exponent({1.0, 1.0}), 1);
  EXPECT_EQ(clock_exponent({0.37, 0.1}), 8);
}

}  // namespace
}  // namespace sigmasweep
