#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace sigmasweep {

/// Numbers between 0 and 1, or `from` and `to`. A failure meanwhile shows the seed.
class Random {
 public:
  explicit Random(std::uint64_t seed)
      : engine_(seed), trace_(__FILE__, __LINE__, testing::Message() << "seed " << seed) {}
  double operator()(double from = 0.0, double to = 1.0) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  /// 64 random bits.
  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
  testing::ScopedTrace trace_;
};

}  // namespace sigmasweep
