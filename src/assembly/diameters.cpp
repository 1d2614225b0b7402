#include "assembly/diameters.hpp"

#include <cmath>
#include <cstdint>

#include "base/random.hpp"

namespace sigmasweep {

/// Cubed and taken back: the digits are then those that independent references were computed with.
std::vector<double> diameters(const Parameters& p) {
  if (p.width == 0.0) return {};
  const std::uint64_t key = stream_key(static_cast<std::uint64_t>(p.seed), "diameter");
  std::vector<double> all;
  for (std::int64_t i = 0; i < p.N; ++i) {
    const double shift = unit_interval(random_bits(key, static_cast<std::uint64_t>(i))) - 0.5;
    const double over_mean = std::fma(p.width / p.d, shift, 1.0);
    all.push_back(p.d * std::cbrt(over_mean * over_mean * over_mean));
  }
  return all;
}

}  // namespace sigmasweep
