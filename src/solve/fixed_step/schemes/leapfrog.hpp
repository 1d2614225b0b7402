#pragma once

#include <array>
#include <cstddef>

#include "solve/fixed_step/aligned_lanes.hpp"
#include "solve/fixed_step/schemes/scheme.hpp"

namespace sigmasweep {

/// Leapfrog with the rates at half steps (kick-drift-kick), as granular codes such as LAMMPS have it: L. Verlet, Phys.
/// Rev. 159, 98 (1967); the half step is R. W. Hockney's, Methods Comput. Phys. 9, 136 (1970). Time in steps:
///     v = u + a/2,   x += v,   a = a(x, v),   u = v + a/2.
/// Unlike Verlet's scheme here it gives the dashpots the rates of half a step ago, which is of first order only, but
/// bears twice the damping: a mode x'' + c x' + k x = 0 is stable for k + 2 c < 4. Without damping the two are the
/// same.
struct Leapfrog {
  static constexpr Integrator id = Integrator::leapfrog;
  static constexpr int evaluations = 1;
  static constexpr StepCost cost{20e-9, 2e-9};

  /// Of (x, u, a): v = u + a/2, x += v, a_new = -k x - c v, u = v + a_new/2.
  static StepMap step_map(const Mode& mode) {
    using Wide = StepMap::Wide;
    const Wide k = mode.k, c = mode.c;
    const std::array<Wide, 3> a{-k, -k - c, (-k - c) / 2};
    return StepMap(3, {1, 1, Wide(1) / 2,                       //
                       a[0] / 2, 1 + a[1] / 2, (1 + a[2]) / 2,  //
                       a[0], a[1], a[2]});
  }

  template <EquationOfMotion Equation>
  class Stepper;
};

template <EquationOfMotion Equation>
class Leapfrog::Stepper {
 public:
  explicit Stepper(const Equation& equation)
      : equation_(equation),
        x_(equation.x),
        u_(equation.u),
        a_(equation.components()),
        half_(equation.components()),
        F_(equation.components()) {
    if constexpr (Equation::driven) a_ = equation.first_acceleration();
  }

  const double* x() const { return x_.data(); }
  const double* u() const { return u_.data(); }

  void step() {
    const std::size_t lanes = equation_.lanes();
    double* x = x_.data();
    double* u = u_.data();
    double* a = a_.data();
    double* half = half_.data();
    double* F = F_.data();
    const auto coupling = equation_.coupling.view();
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      half[k] = u[k] + 0.5 * a[k];
      x[k] += half[k];
    }
    equation_.forces(x, half, F);
    equation_.drive(F, 1.0);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a[k] = coupling.acceleration(F, k);
      u[k] = half[k] + 0.5 * a[k];
    }
  }

  /// Whether the next steps are uniform motion while no contact closes.
  bool coasts() const { return true; }  // a was computed at x: no contact closed, no acceleration left
  void coast(double steps) {
    for (std::size_t k = 0; k < equation_.components(); ++k) x_[k] += steps * u_[k];
  }
  void touch(std::size_t k) { x_[k] = 0.0; }

 private:
  const Equation& equation_;
  AlignedLanes x_, u_, a_, half_, F_;
};

}  // namespace sigmasweep
