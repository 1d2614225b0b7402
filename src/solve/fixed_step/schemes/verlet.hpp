#pragma once

#include <array>
#include <cstddef>

#include "solve/fixed_step/aligned_lanes.hpp"
#include "solve/fixed_step/schemes/scheme.hpp"

namespace sigmasweep {

/// Velocity Verlet (Swope, Andersen, Berens & Wilson, J. Chem. Phys. 76, 637 (1982)). The rates that the dashpots need
/// are predicted over the whole step, which keeps the second order where the force is smooth:
///     x += u + a/2,   a_new = a(x, u + a),   u += (a + a_new)/2.
/// Without damping it is symplectic.
struct Verlet {
  static constexpr Integrator id = Integrator::verlet;
  static constexpr int evaluations = 1;
  static constexpr StepCost cost{20e-9, 2e-9};

  /// Of (x, u, a): x += u + a/2, then a_new = -k x - c (u + a), u += (a + a_new)/2.
  static StepMap step_map(const Mode& mode) {
    using Wide = StepMap::Wide;
    const Wide k = mode.k, c = mode.c;
    const std::array<Wide, 3> a{-k, -k - c, -k / 2 - c};
    return StepMap(3, {1, 1, Wide(1) / 2,                       //
                       a[0] / 2, 1 + a[1] / 2, (1 + a[2]) / 2,  //
                       a[0], a[1], a[2]});
  }

  template <EquationOfMotion Equation>
  class Stepper;
};

template <EquationOfMotion Equation>
class Verlet::Stepper {
 public:
  explicit Stepper(const Equation& equation)
      : equation_(equation),
        x_(equation.x),
        u_(equation.u),
        a_(equation.components()),
        predicted_(equation.components()),
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
    double* predicted = predicted_.data();
    double* F = F_.data();
    const auto coupling = equation_.coupling.view();
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      x[k] += u[k] + 0.5 * a[k];
      predicted[k] = u[k] + a[k];
    }
    equation_.forces(x, predicted, F);
    equation_.drive(F, 1.0);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      const double a_new = coupling.acceleration(F, k);
      u[k] += 0.5 * (a[k] + a_new);
      a[k] = a_new;
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
  AlignedLanes x_, u_, a_, predicted_, F_;
};

}  // namespace sigmasweep
