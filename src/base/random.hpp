#pragma once

#include <cstdint>
#include <string_view>

/// Random numbers as functions of an index: value k needs no other value, no state and no memory, and is the same on
/// every machine (no generator or distribution of the standard library is involved).
namespace sigmasweep {

/// Value k of the SplitMix64 sequence that starts at `key` (Steele, Lea & Flood, OOPSLA 2014).
constexpr std::uint64_t random_bits(std::uint64_t key, std::uint64_t k) {
  std::uint64_t z = key + (k + 1) * 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// The key of a seed and a name. Each name has its own, so that streams with equal seeds are independent.
constexpr std::uint64_t stream_key(std::uint64_t seed, std::string_view name) {
  std::uint64_t key = random_bits(seed, 0);
  for (const char c : name) key = random_bits(key ^ static_cast<unsigned char>(c), 0);
  return key;
}

/// The 53 leading bits as a number in [0, 1).
constexpr double unit_interval(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace sigmasweep
