#pragma once

#include "solve/fixed_step/column/chain.hpp"

namespace sigmasweep {

/// The classical Runge-Kutta scheme of fourth order (W. Kutta, Z. Math. Phys. 46, 435 (1901)) for
/// (x, u)' = (u, a(x, u)), with the stages of x written out:
///     a1 = a(x, u),  a2 = a(x + u/2, u + a1/2),  a3 = a(x + u/2 + a1/4, u + a2/2),  a4 = a(x + u + a2/2, u + a3),
///     x += u + (a1 + a2 + a3)/6,   u += (a1 + 2 a2 + 2 a3 + a4)/6.
template <class Chain>
class RungeKutta4 {
 public:
  explicit RungeKutta4(const Chain& chain)
      : chain_(chain),
        x_(chain.x),
        u_(chain.u),
        xs_(chain.x),
        us_(chain.components()),
        F_(chain.components()),
        a_{AlignedLanes(chain.components()), AlignedLanes(chain.components()), AlignedLanes(chain.components())} {}

  const double* x() const { return x_.data(); }
  const double* u() const { return u_.data(); }

  void step() {
    const std::size_t lanes = chain_.lanes();
    double* x = x_.data();
    double* u = u_.data();
    double* xs = xs_.data();
    double* us = us_.data();
    double* F = F_.data();
    double* a1 = a_[0].data();
    double* a2 = a_[1].data();
    double* a3 = a_[2].data();
    const auto coupling = chain_.coupling.view();
    chain_.forces(x, u, F);
    chain_.drive(F, 0.0);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a1[k] = coupling.acceleration(F, k);
      xs[k] = x[k] + 0.5 * u[k];
      us[k] = u[k] + 0.5 * a1[k];
    }
    chain_.forces(xs, us, F);
    chain_.drive(F, 0.5);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a2[k] = coupling.acceleration(F, k);
      xs[k] = x[k] + 0.5 * u[k] + 0.25 * a1[k];
      us[k] = u[k] + 0.5 * a2[k];
    }
    chain_.forces(xs, us, F);
    chain_.drive(F, 0.5);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      a3[k] = coupling.acceleration(F, k);
      xs[k] = x[k] + u[k] + 0.5 * a2[k];
      us[k] = u[k] + a3[k];
    }
    chain_.forces(xs, us, F);
    chain_.drive(F, 1.0);
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
    for (std::size_t k = 0; k < chain_.components(); ++k) x_[k] += steps * u_[k];
  }
  void touch(std::size_t k) { x_[k] = 0.0; }

 private:
  const Chain& chain_;
  AlignedLanes x_, u_, xs_, us_, F_;
  AlignedLanes a_[3];
};

}  // namespace sigmasweep
