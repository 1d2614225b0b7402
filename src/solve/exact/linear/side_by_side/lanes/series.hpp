#pragma once

#include "solve/exact/linear/side_by_side/lanes/columns.hpp"
#include "solve/exact/linear/side_by_side/lanes/pack.hpp"

namespace sigmasweep::side_by_side {

/// 1/n and 1/n!, as constants.
struct Reciprocals {
  double of[order + 2]{}, of_factorial[order + 2]{};
  constexpr Reciprocals() {
    double factorial = 1.0;
    for (int n = 0; n < order + 2; ++n) {
      factorial *= n > 0 ? n : 1;
      of[n] = n > 0 ? 1.0 / n : 0.0;
      of_factorial[n] = 1.0 / factorial;
    }
  }
};
inline constexpr Reciprocals one_over;

/// The derivatives of the overlaps by t/h at the step's start. With F_k = K h^2 x_k + C h x_k' where contact k is
/// closed and 0 where it is open, and with bead k-1 below contact k and bead k above it,
///     x_k'' = (F_(k-1) - F_k)/m_(k-1) + (F_(k+1) - F_k)/m_k,   of the wall's contact (F_1 - F_0)/m_0,
/// and as these are constant coefficients, the same holds for the derivatives p, p + 1 and p + 2.
/// Of the contacts first..last, beside which all contacts are open.
/// `accelerated` divides a force by the mass of bead k.
template <int Order, class P, class Rows, class Coefficients, class Accelerated>
SIGMASWEEP_LANEWISE void expand(Rows& a, const Coefficients& spring, const Coefficients& dashpot,
                                const Accelerated& accelerated, int first, int last) {
  for (int p = 0; p + 2 <= Order; ++p) {
    const auto force = [&](int k) SIGMASWEEP_INLINE_LAMBDA {
      return fma(P::load(spring[k]), P::load(a[p][k]), P::load(dashpot[k]) * P::load(a[p + 1][k]));
    };
    P here = force(first), below = first == 0 ? P(0) : accelerated(first - 1, here);
    for (int k = first; k <= last; ++k) {
      const P above = k < last ? force(k + 1) : P(0);
      const P acceleration = accelerated(k, above - here);  // of bead k
      (acceleration - below).store(a[p + 2][k]);
      below = acceleration;
      here = above;
    }
  }
}

/// Taylor's formula at s = t/h: x + s/1 (x' + s/2 (x'' + s/3 (...
template <class P>
struct Jet {
  P x, slope;
};
template <int Order, class P>
struct Taylor {
  P over[Order + 1];  ///< s/p

  SIGMASWEEP_LANEWISE explicit Taylor(P s) {
#pragma GCC unroll 24
    for (int p = 1; p <= Order; ++p) over[p] = s * P(static_cast<typename P::Scalar>(one_over.of[p]));
  }
  /// Of the contact k with derivatives a[p][k].
  template <class Rows>
  SIGMASWEEP_LANEWISE Jet<P> jet(const Rows& a, int k) const {
    P term = P::load(a[Order][k]), value = term, slope(0);
#pragma GCC unroll 24
    for (int p = Order; p > 0; --p) {
      slope = fma(slope, over[p], term);
      term = P::load(a[p - 1][k]);
      value = fma(value, over[p], term);
    }
    return {value, slope};
  }
  template <class Rows>
  SIGMASWEEP_LANEWISE P curvature(const Rows& a, int k) const {
    P value = P::load(a[Order][k]);
    for (int p = Order - 2; p > 0; --p) value = fma(value, over[p], P::load(a[p + 1][k]));
    return value;
  }
};

}  // namespace sigmasweep::side_by_side
