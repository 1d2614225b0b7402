#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"

namespace sigmasweep {

/// A sequence of uniform numbers in (-1, 1), the same in every run.
class Noise {
 public:
  double next() { return static_cast<double>(static_cast<std::int64_t>(random_bits(0, drawn_++))) * 0x1p-63; }
  /// Four of 16 bits each, at the price of one.
  std::array<double, 4> four() {
    const std::uint64_t bits = random_bits(0, drawn_++);
    std::array<double, 4> numbers;
    for (int i = 0; i < 4; ++i)
      numbers[static_cast<std::size_t>(i)] = (static_cast<double>((bits >> 16 * i) & 0xffff) - 32767.5) * 0x1p-15;
    return numbers;
  }

 private:
  std::uint64_t drawn_ = 0;
};

}  // namespace sigmasweep
