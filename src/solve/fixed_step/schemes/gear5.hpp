#pragma once

#include <cmath>
#include <cstdint>

#include "solve/fixed_step/column/chain.hpp"

namespace sigmasweep {

/// Gear's predictor-corrector of fifth order for equations of second order with velocity-dependent forces, the paper's
/// scheme (Sec. II A): C. W. Gear, ANL-7126 (1966); M. P. Allen & D. J. Tildesley, Computer Simulation of Liquids
/// (1987), App. E. Nordsieck's six values r_n = x^(n)/n!, time in steps:
///     predict   p_n = sum_(m >= n) binomial(m, n) r_m
///     evaluate  D = a(p_0, p_1)/2 - p_2
///     correct   r_n = p_n + c_n D,   c = 3/16, 251/360, 1, 11/18, 1/6, 1/60
/// one evaluation a step (PEC). Strong damping makes it unstable: stable for about 2 zeta omega dt < 0.16.
template <class Chain>
class Gear5 {
 public:
  explicit Gear5(const Chain& chain)
      : chain_(chain),
        r_{chain.x,
           chain.u,
           AlignedLanes(chain.components()),
           AlignedLanes(chain.components()),
           AlignedLanes(chain.components()),
           AlignedLanes(chain.components())},
        F_(chain.components()) {
    if constexpr (Chain::driven) {
      const AlignedLanes a = chain.first_acceleration();
      for (std::size_t k = 0; k < chain.components(); ++k) r_[2][k] = 0.5 * a[k];
    }
  }

  const double* x() const { return r_[0].data(); }
  const double* u() const { return r_[1].data(); }

  void step() {
    const std::size_t lanes = chain_.lanes();
    double* r0 = r_[0].data();
    double* r1 = r_[1].data();
    double* r2 = r_[2].data();
    double* r3 = r_[3].data();
    double* r4 = r_[4].data();
    double* r5 = r_[5].data();
    double* F = F_.data();
    [[maybe_unused]] const auto contact = chain_.contact();
    const auto coupling = chain_.coupling.view();
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {  // Pascal's triangle
      const double a3 = r3[k], a4 = r4[k], a5 = r5[k];
      r0[k] += r1[k] + r2[k] + a3 + a4 + a5;
      r1[k] += 2.0 * r2[k] + 3.0 * a3 + 4.0 * a4 + 5.0 * a5;
      r2[k] += 3.0 * a3 + 6.0 * a4 + 10.0 * a5;
      r3[k] += 4.0 * a4 + 10.0 * a5;
      r4[k] += 5.0 * a5;
      if constexpr (Chain::one_by_one) F[k] = contact(k, r0[k], r1[k]);
    }
    if constexpr (!Chain::one_by_one) chain_.forces(r0, r1, F);
    chain_.drive(F, 1.0);
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
      for (std::size_t k = 0; k < chain_.components(); ++k) memory = std::fmax(memory, std::fabs(r_[n][k]));
    return memory <= 1e-18 * chain_.speed;  // below the rounding of the rates
  }
  void coast(double steps) {
    for (std::size_t k = 0; k < chain_.components(); ++k) {
      r_[0][k] += steps * r_[1][k];
      r_[2][k] = r_[3][k] = r_[4][k] = r_[5][k] = 0.0;
    }
  }
  void touch(std::size_t k) { r_[0][k] = 0.0; }

 private:
  const Chain& chain_;
  AlignedLanes r_[6];
  AlignedLanes F_;
};

}  // namespace sigmasweep
