#pragma once

#include <algorithm>

#include "solve/exact/linear/column.hpp"

/// Definitions of ExactColumn's members that make its error bars. Included by column_impl.hpp only.

namespace sigmasweep {

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
auto ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::balance() const -> Balance {
  const EnergyBalance<Real> energy(column_, closed_, x_, velocities(0));
  const auto outlook = energy.outlook();
  Balance now{.remaining = outlook.decrease,
              .ahead = 2 * outlook.final_distance,
              .present = outlook.final_distance + outlook.present_distance};
  for (int m = 1; m < motions; ++m) {
    const std::vector<Real> change = velocities(std::size_t(m));
    now.disturbance = std::max(now.disturbance, energy.change(motion_[m].x, change));
    now.distance = std::max(now.distance, energy.distance(motion_[m].x, change));
  }
  return now;
}

/// At any moment sqrt(E/E_0) is off by its disturbance, and from there both the true and the computed one fall by no
/// more than what remains: small disturbances late in a collision may grow large, but have little left to act on.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
Real ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::error(double safety) const {
  const Balance end = balance();
  Real least = Real(safety) * end.disturbance + end.remaining;
  for (const Balance& b : balances_) least = std::min(least, Real(Real(safety) * b.disturbance + b.remaining));
  return least;
}

/// The same for the velocities: from any moment on the true and the computed ones go ways that may differ by what is
/// left to dissipate. The run may have ended before they were final.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
Real ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::velocity_error(double safety) const {
  const Balance end = balance();
  Real least = Real(safety) * end.distance + end.ahead;
  for (const Balance& b : balances_) least = std::min(least, Real(Real(safety) * b.distance + b.ahead));
  return least + end.present;
}

}  // namespace sigmasweep
