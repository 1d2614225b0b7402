#pragma once

#include <stdexcept>

#include "contact/kernels.hpp"
#include "solve/fixed_step/schemes/gear5.hpp"
#include "solve/fixed_step/schemes/rk4.hpp"
#include "solve/fixed_step/schemes/verlet.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace sigmasweep {

/// High derivatives fade to denormal numbers in free flight, on which the processor is about twenty times slower.
class DenormalsAreZero {
#if defined(__SSE2__)
 public:
  DenormalsAreZero() { _mm_setcsr(before_ | 0x8040u); }  // flush to zero, denormals are zero
  ~DenormalsAreZero() { _mm_setcsr(before_); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
#endif
};

/// Calls with.operator()<Force, Uneven>() for the column's law. Beads of equal mass have a kernel of their own with the
/// linear law; with the others they are no special case.
template <class With>
auto with_law(const Column<double>& column, With&& with) {
  const auto [beta, gamma] = column.exponents;
  if (column.exponents.linear() && column.is_uniform()) return with.template operator()<LinearForce, false>();
  if (column.exponents.linear()) return with.template operator()<LinearForce, true>();
  if (beta == 0.5 && gamma == 0.0) return with.template operator()<HertzForce<0>, true>();
  if (beta == 0.5 && gamma == 0.25) return with.template operator()<HertzForce<1>, true>();
  if (beta == 0.5 && gamma == 0.5) return with.template operator()<HertzForce<2>, true>();
  return with.template operator()<PowerForce, true>();
}

/// Calls with.operator()<Scheme>() for the integrator, denormal numbers being zero meanwhile. Throws
/// std::invalid_argument where it has no fixed step.
template <class With>
auto with_scheme(Integrator integrator, With&& with) {
  const DenormalsAreZero guard;
  switch (integrator) {
    case Integrator::gear5: return with.template operator()<Gear5>();
    case Integrator::verlet: return with.template operator()<Verlet>();
    case Integrator::rk4: return with.template operator()<RungeKutta4>();
    case Integrator::exact: break;
  }
  throw std::invalid_argument("with_scheme: not an integrator of fixed step");
}

/// Overlap and rate within steps just done, `s` from 0 to 1 on the way: Hermite's cubic through overlaps and rates a
/// step at both ends, and for the rates, which have a kink where a contact opens or closes, the straight line.
struct BetweenSteps {
  double x, u;
  BetweenSteps(double s, double steps, double x0, double u0, double x1, double u1) {
    const double r = 1.0 - s;
    x = r * r * ((1.0 + 2.0 * s) * x0 + s * steps * u0) + s * s * ((1.0 + 2.0 * r) * x1 - r * steps * u1);
    u = r * u0 + s * u1;
  }
};

}  // namespace sigmasweep
