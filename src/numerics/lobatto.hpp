#pragma once

#include <array>

namespace sigmasweep {

/// A place of a quadrature rule on [0, 1] and its weight. The weights of a rule add up to 1.
struct QuadratureNode {
  double place, weight;
};

/// Rules of Lobatto, whose first and last places are the ends (M. Abramowitz & I. A. Stegun, Handbook of Mathematical
/// Functions, 25.4.32 and Table 25.6). That of n places is exact for polynomials of degree 2n - 3. The one of 3 places
/// is Simpson's.
inline constexpr std::array<QuadratureNode, 3> lobatto3{{{0.0, 1.0 / 6.0}, {0.5, 2.0 / 3.0}, {1.0, 1.0 / 6.0}}};
/// The inner places are (1 +- sqrt((7 -+ 2 sqrt 7)/21))/2, their weights (14 +- sqrt 7)/60.
inline constexpr std::array<QuadratureNode, 6> lobatto6{{{0.0, 1.0 / 30.0},
                                                         {0.11747233803526765, 0.18923747814892349},
                                                         {0.35738424175967745, 0.27742918851774318},
                                                         {0.64261575824032255, 0.27742918851774318},
                                                         {0.88252766196473235, 0.18923747814892349},
                                                         {1.0, 1.0 / 30.0}}};

}  // namespace sigmasweep
