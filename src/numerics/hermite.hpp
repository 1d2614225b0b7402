#pragma once

#include <algorithm>
#include <array>

namespace sigmasweep {

/// A value with its first and second derivatives in time.
template <class Real>
struct Motion {
  Real x{}, u{}, a{};
  Motion operator-() const { return {-x, -u, -a}; }
};

/// Hermite's polynomial of degree five between two motions, the ends of a step of length h. It has their values, first
/// and second derivatives.
template <class Real>
struct Quintic {
  std::array<Real, 6> c;

  Quintic(const Motion<Real>& from, const Motion<Real>& to, const Real& h) {
    const Real v0 = h * from.u, a0 = h * h * from.a, v1 = h * to.u, a1 = h * h * to.a, d = to.x - from.x;
    c = {from.x,
         v0,
         a0 / 2,
         10 * d - 6 * v0 - 4 * v1 - (3 * a0 - a1) / 2,
         -15 * d + 8 * v0 + 7 * v1 + (3 * a0 - 2 * a1) / 2,
         6 * d - 3 * (v0 + v1) - (a0 - a1) / 2};
  }

  /// The motion at fraction s of the step of length h.
  Motion<Real> at(const Real& s, const Real& h) const {
    const Real x = c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
    const Real u = c[1] + s * (2 * c[2] + s * (3 * c[3] + s * (4 * c[4] + s * 5 * c[5])));
    const Real a = 2 * c[2] + s * (6 * c[3] + s * (12 * c[4] + s * 20 * c[5]));
    return {x, u / h, a / (h * h)};
  }

  /// Whether the polynomial is certainly not negative within the step, because none of its Bernstein coefficients is.
  static bool stays_positive(const Motion<Real>& from, const Motion<Real>& to, const Real& h) {
    const Real v0 = h * from.u / 5, a0 = h * h * from.a / 20, v1 = h * to.u / 5, a1 = h * h * to.a / 20;
    return from.x >= 0 && from.x + v0 >= 0 && from.x + 2 * v0 + a0 >= 0 && to.x - 2 * v1 + a1 >= 0 && to.x - v1 >= 0 &&
           to.x >= 0;
  }
};

/// The largest value within a step of length h, or `known` if it is larger.
template <class Real>
Real largest_between(const Motion<Real>& from, const Motion<Real>& to, const Real& h, const Real& known) {
  const Real largest = std::max({known, from.x, to.x});
  if (!(from.u > 0) || !(to.u < 0) || std::max(from.x, to.x) + from.u * h <= largest) return largest;
  const Quintic<Real> x(from, to, h);
  Real low = 0, high = 1;
  for (int i = 0; i < 20; ++i) {
    const Real s = (low + high) / 2;
    (x.at(s, h).u > 0 ? low : high) = s;
  }
  return std::max(largest, x.at(low, h).x);
}

}  // namespace sigmasweep
