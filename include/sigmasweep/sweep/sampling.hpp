#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Random and quasi-random numbers as functions of an index: value k needs no other value, no state and no memory, and
/// is the same on every machine (no generator or distribution of the standard library is involved).
namespace sigmasweep {

/// Value k of the SplitMix64 sequence that starts at `key` (Steele, Lea & Flood, OOPSLA 2014).
std::uint64_t random_bits(std::uint64_t key, std::uint64_t k);

/// A key of its own for every seed and parameter name, so that axes with equal seeds are independent.
std::uint64_t stream_key(std::uint64_t seed, std::string_view name);

/// The 53 leading bits as a number in [0, 1).
double unit_interval(std::uint64_t bits);

/// The place of k in a permutation of 0 .. count-1 chosen by `key`: a Feistel network on the next power of four,
/// walked until it falls below count (Black & Rogaway, CT-RSA 2002).
std::uint64_t shuffled(std::uint64_t k, std::uint64_t count, std::uint64_t key);

/// One dimension of the Sobol sequence with the direction numbers of Joe & Kuo (2008), from Boost. The origin is
/// skipped: the first dimension begins 0.5, 0.75, 0.25, ...
class SobolDimension {
 public:
  explicit SobolDimension(std::size_t dimension);
  /// Point k as a 64-bit binary fraction, k < 2^48 - 1.
  std::uint64_t bits(std::uint64_t k) const;

 private:
  std::array<std::uint64_t, 48> direction_;
};

}  // namespace sigmasweep
