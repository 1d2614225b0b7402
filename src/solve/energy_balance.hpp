#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "sigmasweep/solve/column.hpp"

namespace sigmasweep {

/// Where sqrt(E/E_0), which ends as eps_eff, stands in the midst of a collision; E is kinetic and elastic energy.
template <class Real>
class EnergyBalance {
 public:
  /// Contacts 0 (the wall) to N-1: which are closed, and their overlaps; velocities of the beads above them.
  EnergyBalance(const Column<Real>& column, std::span<const std::uint8_t> closed, std::span<const Real> overlap,
                std::vector<Real> velocity)
      : column_(column), closed_(closed), x_(overlap), v_(std::move(velocity)) {
    using std::sqrt;
    for (const Real& v : v_) energy_ += v * v;
    for (std::size_t k = 0; k < v_.size(); ++k)
      if (closed_[k]) energy_ += column_.spring(k) * x_[k] * x_[k];
    scale_ = sqrt(Real(static_cast<double>(v_.size()))) * column.speed;
  }

  /// At most by this much sqrt(E/E_0) can still fall. A closed contact will hand on int F dt >= -C x from now until it
  /// opens. With that little handed on at once, what residual_dissipation() says holds for the velocities v' that
  /// result: |P v'| is kept of sqrt(E).
  Real remaining() const {
    using std::sqrt;
    std::vector<Real> handed_on = v_;
    Real lost = 0;  // E - |P v'|^2 = (elastic) + (|v|^2 - |v'|^2) + |v' - P v'|^2, twice the energies
    for (std::size_t k = 0; k < v_.size(); ++k) {
      if (!closed_[k]) continue;
      lost += column_.spring(k) * x_[k] * x_[k];
      const Real impulse = column_.dashpot(k) * x_[k];
      handed_on[k] -= impulse;
      if (k > 0) handed_on[k - 1] += impulse;
    }
    for (std::size_t k = 0; k < v_.size(); ++k) lost += (v_[k] - handed_on[k]) * (v_[k] + handed_on[k]);
    lost += distance_to_separated<Real>(handed_on);
    if (!(lost > 0)) return Real(0);
    return lost / ((sqrt(energy_) + sqrt(std::max(Real(energy_ - lost), Real(0)))) * scale_);
  }

  /// The size of the change of sqrt(E/E_0) under a small change of overlaps and velocities; infinite if these are not
  /// finite numbers.
  Real change(std::span<const Real> overlap, std::span<const Real> velocity) const {
    using std::abs, std::sqrt;
    if (!(energy_ > 0)) return Real(0);
    Real half = 0;
    for (std::size_t k = 0; k < v_.size(); ++k) {
      half += v_[k] * velocity[k];
      if (closed_[k]) half += column_.spring(k) * x_[k] * overlap[k];
    }
    const Real size = abs(half) / (sqrt(energy_) * scale_);
    const Real infinity = std::numeric_limits<Real>::infinity();
    return size < infinity ? size : infinity;
  }

 private:
  const Column<Real>& column_;
  std::span<const std::uint8_t> closed_;
  std::span<const Real> x_;
  std::vector<Real> v_;
  Real energy_{}, scale_{};
};

}  // namespace sigmasweep
