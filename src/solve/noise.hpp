#pragma once

#include <cstdint>

namespace sigmasweep {

/// Uniform numbers in (-1, 1), the same in every run: splitmix64 (Steele, Lea & Flood, OOPSLA 2014).
class Noise {
 public:
  double next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>(static_cast<std::int64_t>(z ^ (z >> 31))) * 0x1p-63;
  }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace sigmasweep
