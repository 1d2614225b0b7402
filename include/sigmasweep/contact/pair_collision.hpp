#pragma once

#include "sigmasweep/contact/theory.hpp"

namespace sigmasweep {

/// The collision of a pair, computed from its equation of motion. The error of eps is below 1e-13.
struct PairCollision {
  double eps = 0.0;       ///< restitution; 0 if the pair never separates
  double duration = 0.0;  ///< contact time; infinite if the pair never separates
  double x_max = 0.0;     ///< largest overlap
};
PairCollision collide(const PairLaw& law, double v);

/// The b with which a pair of this k that meets at v has restitution eps, 0 < eps <= 1. NaN if there is none.
double damping(Exponents exponents, double k, double v, double eps);

}  // namespace sigmasweep
