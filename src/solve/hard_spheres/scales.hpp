#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "assembly/column.hpp"
#include "base/quad.hpp"

/// Scales of hard spheres: of length, of speeds, and of rounding.
namespace sigmasweep {

/// Relative size of a difference of two velocities up to which it is rounding and counts as zero.
template <class Real>
inline const Real cancelled = Real(1e-14);
template <>
inline const Quad cancelled<Quad> = Quad(1e-30);

/// The unit of length: the gap, or 1 without a gap.
template <class Real>
Real length_of(const Column<Real>& column) {
  return column.gap > 0 ? column.gap : Real(1);
}

/// Ratio of the speeds of the lightest and the heaviest bead with the same energy.
template <class Real>
Real spread(const std::vector<Real>& mass) {
  using std::sqrt;
  if (mass.empty()) return Real(1);
  const auto [lightest, heaviest] = std::minmax_element(mass.begin(), mass.end());
  return sqrt(*heaviest / *lightest);
}

}  // namespace sigmasweep
