#include "sweep/selection.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

using namespace sigmasweep;

TEST(Selection, FindsTheMembersInOrder) {
  constexpr std::uint32_t seed = 20240607;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 generator(seed);
  for (const std::uint32_t one_in : {1u, 2u, 50u, 9000u}) {
    Selection selection;
    std::vector<std::uint64_t> expected;
    for (std::uint64_t i = 0; i < 50000; ++i) {
      const bool member = generator() % one_in == 0 || i == 49999;
      selection.push(member);
      if (member) expected.push_back(i);
    }
    ASSERT_EQ(selection.size(), expected.size());
    for (std::uint64_t k = 0; k < expected.size(); ++k) ASSERT_EQ(selection[k], expected[k]) << "seed " << seed;
  }
}

TEST(Selection, SkipsLongEmptyStretches) {
  Selection selection;
  for (std::uint64_t i = 0; i < 100000; ++i) selection.push(i == 3 || i == 99999);
  EXPECT_EQ(selection.size(), 2u);
  EXPECT_EQ(selection[0], 3u);
  EXPECT_EQ(selection[1], 99999u);
}
