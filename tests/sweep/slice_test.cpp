#include "sweep/slice.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sigmasweep {
namespace {

TEST(Slice, EveryRowIsInOneSlice) {
  for (const std::uint64_t total : {1u, 2u, 7u, 64u, 1000u})
    for (const std::uint64_t count : {1u, 2u, 3u, 7u, 64u, 1001u}) {
      std::vector<int> seen(total, 0);
      std::uint64_t sum = 0;
      for (std::uint64_t index = 0; index < count; ++index) {
        const Slice slice{index, count};
        sum += slice.size(total);
        for (std::uint64_t k = 0; k < slice.size(total); ++k) {
          const std::uint64_t row = slice.row(k);
          ASSERT_LT(row, total);
          ++seen[row];
          EXPECT_EQ(slice.place(row), k);
          EXPECT_EQ(Slice::with(row, count), slice);
          EXPECT_TRUE(k == 0 || row > slice.row(k - 1));
        }
      }
      EXPECT_EQ(sum, total);
      EXPECT_EQ(seen, std::vector<int>(total, 1)) << total << " rows, " << count << " slices";
    }
}

TEST(Slice, SizesDifferByAtMostOne) {
  for (std::uint64_t index = 0; index < 7; ++index) {
    const std::uint64_t size = Slice{index, 7}.size(1000);
    EXPECT_TRUE(size == 142 || size == 143) << size;
  }
}

TEST(Slice, OfOneIsTheWhole) {
  const Slice whole;
  EXPECT_TRUE(whole.is_whole());
  EXPECT_EQ(whole.size(12), 12u);
  for (std::uint64_t row = 0; row < 12; ++row) EXPECT_EQ(whole.row(row), row);
}

/// Where the last axis has as many values as there are slices, each slice still gets all of them.
TEST(Slice, KeepsNoStepWithAnAxis) {
  constexpr std::uint64_t values = 8;
  std::vector<int> count(values, 0);
  const Slice slice{3, values};
  for (std::uint64_t k = 0; k < slice.size(values * 800); ++k) ++count[slice.row(k) % values];
  for (const int of_value : count) EXPECT_NEAR(of_value, 100, 50);  // five standard deviations of chance
}

/// The slices of parts computed years apart must be the same: these are what the first version had.
TEST(Slice, AreFixedForEver) {
  std::vector<std::uint64_t> rows;
  for (std::uint64_t k = 0; k < 8; ++k) rows.push_back(Slice{1, 3}.row(k));
  EXPECT_EQ(rows, (std::vector<std::uint64_t>{0, 4, 7, 10, 13, 17, 20, 22}));
}

}  // namespace
}  // namespace sigmasweep
