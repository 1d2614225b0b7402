#pragma once

#include "solve/fixed_step/column/chain.hpp"

namespace sigmasweep {

/// Velocity Verlet (Swope, Andersen, Berens & Wilson, J. Chem. Phys. 76, 637 (1982)) with the rates that the dashpots
/// need predicted over the whole step, which keeps the second order where the force is smooth:
///     x += u + a/2,   a_new = a(x, u + a),   u += (a + a_new)/2.
/// Without damping it is symplectic.
template <class Chain>
class Verlet {
 public:
  explicit Verlet(const Chain& chain)
      : chain_(chain),
        x_(chain.x),
        u_(chain.u),
        a_(chain.components()),
        predicted_(chain.components()),
        F_(chain.components()) {
    if constexpr (Chain::driven) a_ = chain.first_acceleration();
  }

  const double* x() const { return x_.data(); }
  const double* u() const { return u_.data(); }

  void step() {
    const std::size_t lanes = chain_.lanes();
    double* x = x_.data();
    double* u = u_.data();
    double* a = a_.data();
    double* predicted = predicted_.data();
    double* F = F_.data();
    const auto coupling = chain_.coupling.view();
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      x[k] += u[k] + 0.5 * a[k];
      predicted[k] = u[k] + a[k];
    }
    chain_.forces(x, predicted, F);
    chain_.drive(F, 1.0);
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
    for (std::size_t k = 0; k < chain_.components(); ++k) x_[k] += steps * u_[k];
  }
  void touch(std::size_t k) { x_[k] = 0.0; }

 private:
  const Chain& chain_;
  AlignedLanes x_, u_, a_, predicted_, F_;
};

}  // namespace sigmasweep
