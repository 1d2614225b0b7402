#pragma once

#include <cstddef>

#include "solve/fixed_step/aligned_lanes.hpp"
#include "solve/fixed_step/schemes/scheme.hpp"

namespace sigmasweep {

/// The classical Runge-Kutta scheme of fourth order (W. Kutta, Z. Math. Phys. 46, 435 (1901)) for
/// (x, u)' = (u, a(x, u)), with the stages of x written out:
///     a1 = a(x, u),  a2 = a(x + u/2, u + a1/2),  a3 = a(x + u/2 + a1/4, u + a2/2),  a4 = a(x + u + a2/2, u + a3),
///     x += u + (a1 + a2 + a3)/6,   u += (a1 + 2 a2 + 2 a3 + a4)/6.
struct RungeKutta4 {
  static constexpr Integrator id = Integrator::rk4;
  static constexpr int evaluations = 4;
  static constexpr StepCost cost{50e-9, 8e-9};

  /// Of (x, u): 1 + M + M^2/2 + M^3/6 + M^4/24 for (x, u)' = M (x, u), where M^2 = -k - c M and so M^n = p + q M.
  static StepMap step_map(const Mode& mode) {
    using Wide = StepMap::Wide;
    const Wide k = mode.k, c = mode.c;
    Wide p = 1, q = 0, P = 1, Q = 0, factor = 1;
    for (int n = 1; n <= 4; ++n) {
      const Wide before = p;
      p = -k * q;
      q = before - c * q;
      factor /= n;
      P += factor * p;
      Q += factor * q;
    }
    return StepMap(2, {P, Q, -k * Q, P - c * Q});  // P + Q M
  }

  template <EquationOfMotion Equation>
  class Stepper;
};

template <EquationOfMotion Equation>
class RungeKutta4::Stepper {
 public:
  explicit Stepper(const Equation& equation)
      : equation_(equation),
        x_(equation.x),
        u_(equation.u),
        xs_(equation.x),
        us_(equation.components()),
        F_(equation.components()),
        a_{AlignedLanes(equation.components()), AlignedLanes(equation.components()),
           AlignedLanes(equation.components())} {}

  const double* x() const { return x_.data(); }
  const double* u() const { return u_.data(); }

  void step() {
    const std::size_t lanes = equation_.lanes();
    double* x = x_.data();
    double* u = u_.data();
    double* xs = xs_.data();
    double* us = us_.data();
    double* F = F_.data();
    double* a1 = a_[0].data();
    double* a2 = a_[1].data();
    double* a3 = a_[2].data();
    const auto coupling = equation_.coupling.view();
    equation_.forces(x, u, F);
    equation_.drive(F, 0.0);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a1[k] = coupling.acceleration(F, k);
      xs[k] = x[k] + 0.5 * u[k];
      us[k] = u[k] + 0.5 * a1[k];
    }
    equation_.forces(xs, us, F);
    equation_.drive(F, 0.5);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a2[k] = coupling.acceleration(F, k);
      xs[k] = x[k] + 0.5 * u[k] + 0.25 * a1[k];
      us[k] = u[k] + 0.5 * a2[k];
    }
    equation_.forces(xs, us, F);
    equation_.drive(F, 0.5);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a3[k] = coupling.acceleration(F, k);
      xs[k] = x[k] + u[k] + 0.5 * a2[k];
      us[k] = u[k] + a3[k];
    }
    equation_.forces(xs, us, F);
    equation_.drive(F, 1.0);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      const double a4 = coupling.acceleration(F, k);
      x[k] += u[k] + (a1[k] + a2[k] + a3[k]) / 6.0;
      u[k] += (a1[k] + 2.0 * (a2[k] + a3[k]) + a4) / 6.0;
    }
  }

  /// Whether the next steps are uniform motion while no contact closes.
  bool coasts() const { return true; }
  void coast(double steps) {
    for (std::size_t k = 0; k < equation_.components(); ++k) x_[k] += steps * u_[k];
  }
  void touch(std::size_t k) { x_[k] = 0.0; }

 private:
  const Equation& equation_;
  AlignedLanes x_, u_, xs_, us_, F_;
  AlignedLanes a_[3];
};

}  // namespace sigmasweep
