#include "sweep/sampling.hpp"

#include <set>

#include <gtest/gtest.h>

using namespace sigmasweep;

// The published test vector of SplitMix64, seed 1234567.
TEST(Sampling, RandomBitsAreSplitMix64) {
  EXPECT_EQ(random_bits(1234567, 0), 6457827717110365317u);
  EXPECT_EQ(random_bits(1234567, 1), 3203168211198807973u);
  EXPECT_EQ(random_bits(1234567, 2), 9817491932198370423u);
  EXPECT_EQ(random_bits(1234567, 3), 4593380528125082431u);
  EXPECT_EQ(random_bits(1234567, 4), 16408922859458223821u);
}

TEST(Sampling, StreamsDifferBySeedAndName) {
  std::set<std::uint64_t> keys;
  for (const std::uint64_t seed : {0u, 1u, 2u})
    for (const char* name : {"v0", "tc", "s0", "sigma", "N", "d"}) keys.insert(stream_key(seed, name));
  EXPECT_EQ(keys.size(), 18u);
}

TEST(Sampling, UnitIntervalIsHalfOpen) {
  EXPECT_EQ(unit_interval(0), 0.0);
  EXPECT_EQ(unit_interval(std::uint64_t{1} << 63), 0.5);
  EXPECT_EQ(unit_interval(~std::uint64_t{0}), 1.0 - 0x1p-53);
}

TEST(Sampling, ShuffledIsAPermutation) {
  for (const std::uint64_t count : {1u, 2u, 3u, 4u, 5u, 16u, 17u, 100u, 1000u, 4097u}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t place = shuffled(k, count, 42);
      EXPECT_LT(place, count);
      places.insert(place);
    }
    EXPECT_EQ(places.size(), count);
  }
}

TEST(Sampling, ShuffledDependsOnTheKeyAndMixes) {
  int moved = 0, kept = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    moved += shuffled(k, 1000, 1) != shuffled(k, 1000, 2);
    kept += shuffled(k, 1000, 1) == k;
  }
  EXPECT_GT(moved, 980);  // a random permutation agrees with another in about 1 place, Poisson distributed
  EXPECT_LT(kept, 20);
}

// The first points printed by Joe and Kuo for their table new-joe-kuo-6.
TEST(Sampling, SobolBeginsAsPublished) {
  const double published[8][3] = {{0, 0, 0},
                                  {0.5, 0.5, 0.5},
                                  {0.75, 0.25, 0.25},
                                  {0.25, 0.75, 0.75},
                                  {0.375, 0.375, 0.625},
                                  {0.875, 0.875, 0.125},
                                  {0.625, 0.125, 0.875},
                                  {0.125, 0.625, 0.375}};
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    const SobolDimension sobol(dimension);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(unit_interval(sobol.bits(k)), published[k][dimension]) << k;
  }
}

TEST(Sampling, SobolFillsEveryDyadicInterval) {
  for (const std::size_t dimension : {0u, 1u, 2u, 5u, 11u}) {
    const SobolDimension sobol(dimension);
    std::set<std::uint64_t> cells;
    for (std::uint64_t k = 0; k < 1024; ++k) cells.insert(sobol.bits(k) >> 54);
    EXPECT_EQ(cells.size(), 1024u) << dimension;
  }
}

// The first two dimensions are a (0, m, 2)-net in base 2: each box of area 2^-m and sides 2^-a, 2^-(m-a) holds one of
// the 2^m points (Sobol 1967).
TEST(Sampling, SobolsFirstPowersOfTwoAreNets) {
  const SobolDimension x(0), y(1);
  for (unsigned m = 1; m <= 10; ++m)
    for (unsigned a = 0; a <= m; ++a) {
      std::set<std::uint64_t> boxes;
      const auto leading = [](std::uint64_t bits, unsigned count) { return count == 0 ? 0 : bits >> (64 - count); };
      for (std::uint64_t k = 0; k < std::uint64_t{1} << m; ++k)
        boxes.insert(leading(x.bits(k), a) << (m - a) | leading(y.bits(k), m - a));
      EXPECT_EQ(boxes.size(), std::size_t{1} << m) << m << " " << a;
    }
}
