#pragma once

#include <cstdint>

#include "base/random.hpp"

namespace sigmasweep {

/// A sequence of uniform numbers in (-1, 1), the same in every run.
class Noise {
 public:
  double next() { return static_cast<double>(static_cast<std::int64_t>(random_bits(0, drawn_++))) * 0x1p-63; }

 private:
  std::uint64_t drawn_ = 0;
};

}  // namespace sigmasweep
