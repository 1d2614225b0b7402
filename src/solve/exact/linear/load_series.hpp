#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "assembly/ground.hpp"

namespace sigmasweep {

/// Terms of the load of a vibrated plate, load(start + s h) = g - A0 omega^2 sin(omega start + omega h s), as a series
/// in s.
template <std::size_t Terms>
std::array<double, Terms> load_series(const Plate& plate, double start, double h) {
  const double phase = plate.omega * start, angle = plate.omega * h;
  const std::array<double, 4> derivatives{std::sin(phase), std::cos(phase), -std::sin(phase), -std::cos(phase)};
  std::array<double, Terms> terms;
  double factor = -plate.A0 * plate.omega * plate.omega;
  for (std::size_t p = 0; p < Terms; factor *= angle / double(++p)) terms[p] = factor * derivatives[p % 4];
  terms[0] += plate.g;
  return terms;
}

}  // namespace sigmasweep
