#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"

/// Quasi-random numbers as functions of an index, as the random numbers of base/random.hpp are.
namespace sigmasweep {

/// The place of k in a permutation of 0 .. count-1 that `key` chooses: a Feistel network on the next power of four,
/// repeated until the result is below count (Black & Rogaway, CT-RSA 2002).
std::uint64_t shuffled(std::uint64_t k, std::uint64_t count, std::uint64_t key);

/// A dimension of the Sobol sequence with the direction numbers of Joe & Kuo (2008), from Boost. It begins with the
/// origin, 0, 0.5, 0.75, 0.25, ..., so that the first 2^m points are a net: each of 2^m equal parts of the interval
/// has one of them (Owen, MCQMC 2020: without the origin they are none).
class SobolDimension {
 public:
  explicit SobolDimension(std::size_t dimension);
  /// Point k as a 64-bit binary fraction, k < 2^48.
  std::uint64_t bits(std::uint64_t k) const;

 private:
  std::array<std::uint64_t, 48> direction_;
};

}  // namespace sigmasweep
