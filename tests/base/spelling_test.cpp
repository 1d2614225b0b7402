#include "base/spelling.hpp"

#include <array>

#include <gtest/gtest.h>

using namespace sigmasweep;

namespace {

constexpr std::array<std::string_view, 12> known{
    "v0", "tc", "s0", "sigma", "N", "epsilon", "method", "wall", "integrator", "d", "steps_per_tc", "tolerance"};

std::string near(std::string_view name) { return std::string(nearest(name, known).value_or("-")); }

}  // namespace

TEST(Spelling, FindsWhatWasMeant) {
  EXPECT_EQ(near("epsilom"), "epsilon");
  EXPECT_EQ(near("eps"), "epsilon");
  EXPECT_EQ(near("sgima"), "sigma");
  EXPECT_EQ(near("n"), "N");
  EXPECT_EQ(near("t_c"), "tc");
  EXPECT_EQ(near("V0"), "v0");
  EXPECT_EQ(near("steps"), "steps_per_tc");
  EXPECT_EQ(near("tolerence"), "tolerance");
}

TEST(Spelling, DoesNotGuessWildly) {
  EXPECT_EQ(near("x"), "-");
  EXPECT_EQ(near(""), "-");
  EXPECT_EQ(near("gravity"), "-");
  EXPECT_EQ(near(std::string(100000, 'e')), "-");
}

TEST(Spelling, HintsAndAlternatives) {
  const std::array<std::string_view, 3> names{"a", "b", "c"};
  EXPECT_EQ(hint("epsilom", known), " (did you mean 'epsilon'?)");
  EXPECT_EQ(hint("zzz", names), "; known: a, b, c");
  EXPECT_EQ(alternatives(names), "'a', 'b' or 'c'");
}
