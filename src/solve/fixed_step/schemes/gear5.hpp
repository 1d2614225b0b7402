#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "solve/fixed_step/aligned_lanes.hpp"
#include "solve/fixed_step/schemes/scheme.hpp"

namespace sigmasweep {

/// Gear's predictor-corrector of fifth order for equations of second order with velocity-dependent forces, the paper's
/// scheme (Sec. II A): C. W. Gear, ANL-7126 (1966); M. P. Allen & D. J. Tildesley, Computer Simulation of Liquids
/// (1987), App. E. Nordsieck's six values are r_n = x^(n)/n!, time in steps:
///     predict   p_n = sum_(m >= n) binomial(m, n) r_m
///     evaluate  D = a(p_0, p_1)/2 - p_2
///     correct   r_n = p_n + c_n D,   c = 3/16, 251/360, 1, 11/18, 1/6, 1/60
/// The forces are evaluated once in a step (PEC). Strong damping makes the scheme unstable: it is stable for about
/// 2 zeta omega dt < 0.16.
struct Gear5 {
  static constexpr Integrator id = Integrator::gear5;
  static constexpr int evaluations = 1;
  static constexpr StepCost cost{20e-9, 5e-9};

  /// Of r_n, n = 0 to 5: predict with Pascal's triangle, correct with D = -(k p_0 + c p_1)/2 - p_2.
  static StepMap step_map(const Mode& mode) {
    using Wide = StepMap::Wide;
    StepMap predict(6);
    for (std::size_t n = 0; n < 6; ++n)
      for (std::size_t m = n; m < 6; ++m)
        predict(n, m) = m == n || n == 0 ? Wide(1) : predict(n - 1, m - 1) + predict(n, m - 1);
    constexpr std::array<Wide, 6> correct{3.0L / 16, 251.0L / 360, 1.0L, 11.0L / 18, 1.0L / 6, 1.0L / 60};
    StepMap map = predict;
    for (std::size_t m = 0; m < 6; ++m) {
      const Wide D = -(mode.k * predict(0, m) + mode.c * predict(1, m)) / 2 - predict(2, m);
      for (std::size_t n = 0; n < 6; ++n) map(n, m) += correct[n] * D;
    }
    return map;
  }

  template <EquationOfMotion Equation>
  class Stepper;
};

template <EquationOfMotion Equation>
class Gear5::Stepper {
 public:
  explicit Stepper(const Equation& equation)
      : equation_(equation),
        r_{equation.x,
           equation.u,
           AlignedLanes(equation.components()),
           AlignedLanes(equation.components()),
           AlignedLanes(equation.components()),
           AlignedLanes(equation.components())},
        F_(equation.components()) {
    if constexpr (Equation::driven) {
      const AlignedLanes a = equation.first_acceleration();
      for (std::size_t k = 0; k < equation.components(); ++k) r_[2][k] = 0.5 * a[k];
    }
  }

  const double* x() const { return r_[0].data(); }
  const double* u() const { return r_[1].data(); }

  void step() {
    const std::size_t lanes = equation_.lanes();
    double* r0 = r_[0].data();
    double* r1 = r_[1].data();
    double* r2 = r_[2].data();
    double* r3 = r_[3].data();
    double* r4 = r_[4].data();
    double* r5 = r_[5].data();
    double* F = F_.data();
    [[maybe_unused]] const auto contact = equation_.contact();
    const auto coupling = equation_.coupling.view();
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {  // Pascal's triangle
      const double a3 = r3[k], a4 = r4[k], a5 = r5[k];
      r0[k] += r1[k] + r2[k] + a3 + a4 + a5;
      r1[k] += 2.0 * r2[k] + 3.0 * a3 + 4.0 * a4 + 5.0 * a5;
      r2[k] += 3.0 * a3 + 6.0 * a4 + 10.0 * a5;
      r3[k] += 4.0 * a4 + 10.0 * a5;
      r4[k] += 5.0 * a5;
      if constexpr (Equation::one_by_one) F[k] = contact(k, r0[k], r1[k]);
    }
    if constexpr (!Equation::one_by_one) equation_.forces(r0, r1, F);
    equation_.drive(F, 1.0);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      const double D = 0.5 * coupling.acceleration(F, k) - r2[k];
      r0[k] += 3.0 / 16.0 * D;
      r1[k] += 251.0 / 360.0 * D;
      r2[k] += D;
      r3[k] += 11.0 / 18.0 * D;
      r4[k] += 1.0 / 6.0 * D;
      r5[k] += 1.0 / 60.0 * D;
    }
  }

  /// Whether the next steps are uniform motion while no contact closes: the memory of past forces has faded.
  bool coasts() const {
    double memory = 0.0;
    for (std::size_t n = 2; n < 6; ++n)
      for (std::size_t k = 0; k < equation_.components(); ++k) memory = std::fmax(memory, std::fabs(r_[n][k]));
    return memory <= 1e-18 * equation_.speed;  // below the rounding of the rates
  }
  void coast(double steps) {
    for (std::size_t k = 0; k < equation_.components(); ++k) {
      r_[0][k] += steps * r_[1][k];
      r_[2][k] = r_[3][k] = r_[4][k] = r_[5][k] = 0.0;
    }
  }
  void touch(std::size_t k) { r_[0][k] = 0.0; }

 private:
  const Equation& equation_;
  AlignedLanes r_[6];
  AlignedLanes F_;
};

}  // namespace sigmasweep
