#include "sweep/sampling.hpp"

#include <bit>

#include <boost/random/sobol.hpp>

namespace sigmasweep {

std::uint64_t shuffled(std::uint64_t k, std::uint64_t count, std::uint64_t key) {
  if (count < 2) return 0;
  const auto half = (static_cast<unsigned>(std::bit_width(count - 1)) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  constexpr std::uint64_t rounds = 6;
  do {
    std::uint64_t left = k >> half, right = k & mask;
    for (std::uint64_t round = 0; round < rounds; ++round) {
      const std::uint64_t next = left ^ (random_bits(random_bits(key, round), right) & mask);
      left = right;
      right = next;
    }
    k = left << half | right;
  } while (k >= count);
  return k;
}

SobolDimension::SobolDimension(std::size_t dimension) {
  // Point n is the exclusive or of the direction numbers at the bits of the Gray code of n. The Gray code of
  // n = 2^(j+1) - 1 is the single bit j: this point is direction number j. Boost leaves out point 0, the origin.
  boost::random::sobol engine(dimension + 1);
  for (std::size_t j = 0; j < direction_.size(); ++j) {
    engine.seed((std::uint64_t{1} << (j + 1)) - 2);
    for (std::size_t skip = 0; skip < dimension; ++skip) engine();
    direction_[j] = engine();
  }
}

std::uint64_t SobolDimension::bits(std::uint64_t k) const {
  std::uint64_t sum = 0;
  for (std::uint64_t gray = k ^ (k >> 1); gray != 0; gray &= gray - 1)
    sum ^= direction_[static_cast<std::size_t>(std::countr_zero(gray))];
  return sum;
}

}  // namespace sigmasweep
