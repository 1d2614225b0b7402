#include "sigmasweep/sweep/sampling.hpp"

#include <bit>

#include <boost/random/sobol.hpp>

namespace sigmasweep {
namespace {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;

constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t random_bits(std::uint64_t key, std::uint64_t k) { return mix(key + (k + 1) * golden); }

std::uint64_t stream_key(std::uint64_t seed, std::string_view name) {
  std::uint64_t key = random_bits(seed, 0);
  for (const char c : name) key = random_bits(key ^ static_cast<unsigned char>(c), 0);
  return key;
}

double unit_interval(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

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
  // Point n is the exclusive or of the direction numbers at the bits of the Gray code of n + 1 (Boost has no origin),
  // so the point whose Gray code is the single bit j, n + 1 = 2^(j+1) - 1, is direction number j itself.
  boost::random::sobol engine(dimension + 1);
  for (std::size_t j = 0; j < direction_.size(); ++j) {
    engine.seed((std::uint64_t{1} << (j + 1)) - 2);
    for (std::size_t skip = 0; skip < dimension; ++skip) engine();
    direction_[j] = engine();
  }
}

std::uint64_t SobolDimension::bits(std::uint64_t k) const {
  std::uint64_t sum = 0;
  for (std::uint64_t gray = (k + 1) ^ ((k + 1) >> 1); gray != 0; gray &= gray - 1)
    sum ^= direction_[static_cast<std::size_t>(std::countr_zero(gray))];
  return sum;
}

}  // namespace sigmasweep
