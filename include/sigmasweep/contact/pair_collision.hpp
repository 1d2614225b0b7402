#pragma once

#include "sigmasweep/contact/theory.hpp"

namespace sigmasweep {

/// How a pair comes apart again, from the equation of motion itself. Errors of eps below 1e-13.
struct PairCollision {
  double eps = 0.0;       ///< restitution; 0 if it never comes apart
  double duration = 0.0;  ///< contact time; infinite if it never comes apart
  double x_max = 0.0;     ///< largest overlap
};
PairCollision collide(const PairLaw& law, double v);

/// The b for which a pair that meets at v has restitution eps, for the k given. 0 < eps <= 1. NaN if there is none.
double damping(Exponents exponents, double k, double v, double eps);

}  // namespace sigmasweep
