#pragma once

#include "solve/exact/linear/side_by_side/lanes/columns.hpp"
#include "solve/exact/linear/side_by_side/lanes/pack.hpp"

namespace sigmasweep::side_by_side {

/// 1/n, as constants.
struct Reciprocals {
  double of[order + 3]{};
  constexpr Reciprocals() {
    for (int n = 1; n < order + 3; ++n) of[n] = 1.0 / n;
  }
};
inline constexpr Reciprocals one_over;

/// The Taylor series of all contacts about the step's start, in t/h. With F_k = K x_k + C x_k' where contact k is
/// closed and 0 where it is open, and bead mass 1,
///     x_k'' = F_(k-1) - w F_k + F_(k+1),   w = 2, of the wall's contact 1,
/// so that the terms p and p + 1 give term p + 2:
///     a_(p+2) = F_(k-1) - w F_k + F_(k+1),   F = K h^2/((p+1)(p+2)) a_p + C h/(p+2) a_(p+1).
/// Of the contacts first..last, beside which all contacts are open.
template <int W, int Order>
SIGMASWEEP_LANEWISE void expand(const Columns<W>& c, double (*a)[W], int first, int last) {
  using P = Pack<W>;
  const int N = c.N;
  const P spring = P::load(c.spring), dashpot = P::load(c.dashpot);
  const P wall_spring = P::load(c.wall_spring), wall_dashpot = P::load(c.wall_dashpot);
  for (int p = 0; p + 2 <= Order; ++p) {
    const P of_spring(one_over.of[p + 1] * one_over.of[p + 2]), of_dashpot(one_over.of[p + 2]);
    const P K = spring * of_spring, C = dashpot * of_dashpot;
    const double(*const now)[W] = a + p * N, (*const next)[W] = a + (p + 1) * N;
    double(*const result)[W] = a + (p + 2) * N;
    const auto force = [&](int k, P stiffness, P damping) SIGMASWEEP_INLINE_LAMBDA {
      return where(Mask<W>::load(c.closed[k]), fma(stiffness, P::load(now[k]), damping * P::load(next[k])));
    };
    P below(0.0), here, own;
    if (first == 0) {
      here = own = force(0, wall_spring * of_spring, wall_dashpot * of_dashpot);
    } else {
      here = force(first, K, C);
      own = here + here;
    }
    for (int k = first; k <= last; ++k) {
      const P above = k < last ? force(k + 1, K, C) : P(0.0);
      ((below + above) - own).store(result[k]);
      below = here;
      here = above;
      own = above + above;
    }
  }
}

/// Value and slope of the series of contact k at s.
template <int W>
struct Jet {
  Pack<W> x, slope;
};
template <int W, int Order>
SIGMASWEEP_LANEWISE Jet<W> jet(const double (*a)[W], int N, int k, Pack<W> s) {
  using P = Pack<W>;
  P value = P::load(a[Order * N + k]), slope(0.0);
  for (int p = Order - 1; p >= 0; --p) {
    slope = fma(slope, s, value);
    value = fma(value, s, P::load(a[p * N + k]));
  }
  return {value, slope};
}

}  // namespace sigmasweep::side_by_side
