#include "sweep/axis.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

using namespace sigmasweep;

namespace {

std::vector<double> values(const Axis& axis) {
  std::vector<double> all;
  for (std::uint64_t k = 0; k < axis.size(); ++k) all.push_back(static_cast<double>(axis[k]));
  return all;
}

}  // namespace

TEST(Axis, LinearRangeGivesTheDoublesOneWouldWrite) {
  EXPECT_EQ(values(Axis::range({0.1, 1.0}, 10)), (std::vector{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}));
  EXPECT_EQ(values(Axis::range({0.99, 0.95}, 5)), (std::vector{0.99, 0.98, 0.97, 0.96, 0.95}));
  EXPECT_EQ(values(Axis::range({3.0, 3.0}, 1)), std::vector{3.0});
}

TEST(Axis, LogarithmicRangeHitsItsDecades) {
  const Axis axis = Axis::range({1e-9, 1e-3, true}, 61);
  const double decades[] = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3};
  for (std::uint64_t i = 0; i < 7; ++i) EXPECT_EQ(axis[10 * i], decades[i]);
  EXPECT_NEAR(static_cast<double>(axis[1]) / 1e-9, 1.2589254117941673, 3e-16);  // 10^0.1
  EXPECT_EQ(values(Axis::range({100.0, 1.0, true}, 3)), (std::vector{100.0, 10.0, 1.0}));
}

TEST(Axis, EndPointsAreExactAndNothingLeavesThem) {
  for (const bool log : {false, true}) {
    const double from = 0.1 + 0.2, to = 1e300 / 3.0;
    const Axis axis = Axis::range({from, to, log}, 5000);  // longer than what is tabulated
    EXPECT_EQ(axis[0], from);
    EXPECT_EQ(axis[4999], to);
    for (std::uint64_t k = 1; k < 5000; ++k) ASSERT_GT(axis[k], axis[k - 1]) << k;
  }
}

TEST(Axis, ExtremeRangesStayFinite) {
  const Axis axis = Axis::range({5e-324, 1.7976931348623157e308, true}, 3);
  EXPECT_NEAR(static_cast<double>(axis[1]) / 2.998077e-8, 1.0, 1e-6);  // sqrt(5e-324 * 1.7976931e308), both as written
  EXPECT_EQ(axis[2], 1.7976931348623157e308);
}

TEST(Axis, RangesOfWholeNumbers) {
  EXPECT_EQ(values(Axis::range({1, 10, false, true}, 4)), (std::vector{1.0, 4.0, 7.0, 10.0}));
  EXPECT_TRUE(has_whole_step({1, 10, false, true}, 4));
  EXPECT_TRUE(has_whole_step({10, 1, false, true}, 10));
  EXPECT_FALSE(has_whole_step({1, 10, false, true}, 5));
  EXPECT_EQ(values(Axis::range({1, 10, true, true}, 10)), (std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}));
}

TEST(Axis, WholeNumbersHave64Bits) {
  constexpr std::int64_t most = INT64_MAX;
  const auto whole = [](const Axis& axis, std::uint64_t k) { return static_cast<std::int64_t>(axis[k]); };
  const Axis axis = Axis::range({AnyNumber(most - 20000), AnyNumber(most), false, true}, 10001);
  for (std::uint64_t k = 0; k <= 10000; ++k) ASSERT_EQ(whole(axis, k), most - 20000 + 2 * static_cast<std::int64_t>(k));
  EXPECT_FALSE(has_whole_step({AnyNumber(most - 20001), AnyNumber(most), false, true}, 10001));
  const Axis sample = Axis::sample({AnyNumber(most - 5), AnyNumber(most), false, true}, 100, {SampleKind::uniform, 1});
  std::set<std::int64_t> seen;
  for (std::uint64_t k = 0; k < 100; ++k) seen.insert(whole(sample, k));
  EXPECT_EQ(seen, (std::set{most - 5, most - 4, most - 3, most - 2, most - 1, most}));
}

TEST(Axis, LongRangesCostNoMemory) {
  const std::uint64_t count = std::uint64_t{1} << 40;
  const Axis axis = Axis::range({0.0, 1.0}, count);
  EXPECT_EQ(axis.size(), count);
  EXPECT_EQ(axis[count - 1], 1.0);
  EXPECT_NEAR(static_cast<double>(axis[count / 2]), 0.5, 1e-12);  // the step is 9e-13
}

// Golden values from exact rational arithmetic on SplitMix64, computed independently.
TEST(Axis, UniformSamplesAreTheSameEverywhere) {
  const Axis axis = Axis::sample({0.5, 1.0}, 4, {SampleKind::uniform, stream_key(1, "epsilon")});
  EXPECT_EQ(values(axis), (std::vector{0.7200253864136159, 0.7434618213824052, 0.657390273803284, 0.635959526558552}));
}

TEST(Axis, LogUniformSamplesAreTheSameEverywhere) {
  const Axis axis = Axis::sample({0.1, 10.0, true}, 4, {SampleKind::uniform, stream_key(7, "v0")});
  const double golden[] = {0.1301885743658089, 5.088380946881539, 3.8764294128389962, 0.21541268491175072};
  for (std::uint64_t k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(static_cast<double>(axis[k]), golden[k]);
}

TEST(Axis, SamplesOfWholeNumbersShareTheIntervalEvenly) {
  const Axis die = Axis::sample({1, 6, false, true}, 12, {SampleKind::uniform, stream_key(3, "N")});
  EXPECT_EQ(values(die), (std::vector{6.0, 2.0, 5.0, 3.0, 4.0, 5.0, 4.0, 3.0, 2.0, 4.0, 5.0, 6.0}));
  const Axis many = Axis::sample({1, 6, false, true}, 60000, {SampleKind::uniform, stream_key(4, "N")});
  std::vector<int> seen(7);
  for (std::uint64_t k = 0; k < many.size(); ++k) ++seen[static_cast<std::size_t>(many[k])];
  for (int side = 1; side <= 6; ++side) EXPECT_NEAR(seen[side], 10000, 500) << side;  // 5.5 standard deviations
}

TEST(Axis, SobolSamplesWithAndWithoutShift) {
  EXPECT_EQ(values(Axis::sample({0.0, 8.0}, 4, {SampleKind::sobol, 0, 0})), (std::vector{0.0, 4.0, 6.0, 2.0}));
  EXPECT_EQ(values(Axis::sample({0.0, 8.0}, 4, {SampleKind::sobol, 0, 1})), (std::vector{0.0, 4.0, 2.0, 6.0}));
  auto shifted = values(Axis::sample({0.0, 1.0}, 5, {SampleKind::sobol, stream_key(5, "sigma"), 0}));
  EXPECT_EQ(shifted.front(), unit_interval(stream_key(5, "sigma")));
  shifted.erase(shifted.begin());
  EXPECT_EQ(shifted, (std::vector{0.8815985008354359, 0.6315985008354359, 0.1315985008354359, 0.006598500835435894}));
}

TEST(Axis, LatinHypercubeHasOneValueInEachStratum) {
  for (const std::uint64_t count : {1u, 7u, 100u, 10000u}) {
    const Axis axis = Axis::sample({0.0, 1.0}, count, {SampleKind::latin_hypercube, stream_key(9, "sigma")});
    auto sorted = values(axis);
    EXPECT_EQ(std::is_sorted(sorted.begin(), sorted.end()), count == 1);
    std::sort(sorted.begin(), sorted.end());
    for (std::uint64_t k = 0; k < count; ++k) {
      EXPECT_GE(sorted[k] * static_cast<double>(count), static_cast<double>(k) * (1 - 1e-12));
      EXPECT_LE(sorted[k] * static_cast<double>(count), static_cast<double>(k + 1) * (1 + 1e-12));
    }
  }
}

TEST(Axis, TabulatedAndComputedValuesAgree) {
  const Sampling sampling{SampleKind::uniform, 77};
  const Axis brief = Axis::sample({1e-3, 1e3, true}, 100, sampling);
  const Axis ample = Axis::sample({1e-3, 1e3, true}, 9999, sampling);
  for (std::uint64_t k = 0; k < 100; ++k) EXPECT_EQ(brief[k], ample[k]);
}

TEST(Axis, BoundsHoldAllValues) {
  EXPECT_EQ(Axis::list({3.0, 1.0, 2.0}).bounds(), (std::pair<AnyNumber, AnyNumber>{1, 3}));
  EXPECT_EQ(Axis::range({9.0, 1.0}, 5000).bounds(), (std::pair<AnyNumber, AnyNumber>{1, 9}));
}
