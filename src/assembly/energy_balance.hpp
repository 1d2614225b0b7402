#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energies.hpp"
#include "contact/contact_law.hpp"

namespace sigmasweep {

/// The energy balance during a collision, for any law and any masses. E is the kinetic and elastic energy; sqrt(E/E_0)
/// becomes eps_eff at the end.
template <class Real>
class EnergyBalance {
 public:
  /// `closed` and `overlap` are of contacts 0 (the wall) to N-1, `velocity` of the beads above them.
  EnergyBalance(const Column<Real>& column, std::span<const std::uint8_t> closed, std::span<const Real> overlap,
                std::vector<Real> velocity)
      : column_(column), closed_(closed), x_(overlap), v_(std::move(velocity)) {
    using std::sqrt;
    for (std::size_t i = 0; i < v_.size(); ++i) energy_ += weighted(i, v_[i] * v_[i]);
    for (std::size_t k = 0; k < v_.size(); ++k)
      if (closed_[k]) energy_ += elastic(k);
    Real mass(static_cast<double>(v_.size()));
    if (!column.mass.empty()) mass = std::accumulate(column.mass.begin(), column.mass.end(), Real(0));
    scale_ = sqrt(mass) * column.speed;
  }

  /// Upper bound of the further decrease of sqrt(E/E_0). A closed contact will transfer the momentum int F dt >= -C
  /// x^(1+gamma)/(1+gamma) until it opens. If it transfers this minimum at once, the velocities v' result, for which
  /// residual_dissipation() holds: |P v'| remains of sqrt(E). Norms are weighted with the masses.
  Real remaining() const { return outlook().decrease; }

  /// How far from the present ones the final velocities may be, as mass-weighted root mean squares over the initial
  /// speed. Final velocities w have got what P v' still hands upwards, so <w, P v'> >= |P v'|^2, and |w|^2 <= E: they
  /// lie within sqrt(E - |P v'|^2) of P v'.
  struct Outlook {
    Real decrease{};          ///< bound of the further decrease of sqrt(E/E_0)
    Real final_distance{};    ///< at most, of the final velocities from P v'
    Real present_distance{};  ///< at most, of the present velocities from P v'
  };
  Outlook outlook() const {
    using std::sqrt;
    std::vector<Real> handed_on = v_;
    Real lost = 0;  // E - |P v'|^2 = (elastic) + (|v|^2 - |v'|^2) + |v' - P v'|^2, twice the energies
    for (std::size_t k = 0; k < v_.size(); ++k) {
      if (!closed_[k]) continue;
      lost += elastic(k);
      const Real impulse = still_to_come(k);
      handed_on[k] -= per_mass(k, impulse);
      if (k > 0) handed_on[k - 1] += per_mass(k - 1, impulse);
    }
    Real handed = 0;
    for (std::size_t k = 0; k < v_.size(); ++k) {
      lost += weighted(k, (v_[k] - handed_on[k]) * (v_[k] + handed_on[k]));
      handed += weighted(k, (v_[k] - handed_on[k]) * (v_[k] - handed_on[k]));
    }
    const auto [apart, kept] = project_on_separated<Real>(handed_on, column_.mass);
    lost += apart;
    if (!(lost > 0)) return {};
    return {lost / ((sqrt(energy_) + sqrt(kept)) * scale_), sqrt(lost) / scale_, (sqrt(handed) + sqrt(apart)) / scale_};
  }

  /// The size of the change of sqrt(E/E_0) under a small change of overlaps and velocities (linear law); infinite if
  /// these are not finite numbers.
  Real change(std::span<const Real> overlap, std::span<const Real> velocity) const {
    using std::abs, std::sqrt;
    if (!(energy_ > 0)) return Real(0);
    Real half = 0;
    for (std::size_t k = 0; k < v_.size(); ++k) {
      half += weighted(k, v_[k] * velocity[k]);
      if (closed_[k]) half += column_.spring(k) * x_[k] * overlap[k];
    }
    return finite_or_infinite(abs(half) / (sqrt(energy_) * scale_));
  }

  /// The size of such a change itself: the root of twice its energy, over that of all beads at the initial speed.
  Real distance(std::span<const Real> overlap, std::span<const Real> velocity) const {
    using std::sqrt;
    Real squares = 0;
    for (std::size_t k = 0; k < v_.size(); ++k) {
      squares += weighted(k, velocity[k] * velocity[k]);
      if (closed_[k]) squares += column_.spring(k) * overlap[k] * overlap[k];
    }
    return finite_or_infinite(sqrt(squares) / scale_);
  }

 private:
  static Real finite_or_infinite(const Real& size) {
    const Real infinity = std::numeric_limits<Real>::infinity();
    return size < infinity ? size : infinity;
  }
  /// Twice the elastic energy.
  Real elastic(std::size_t k) const { return twice_elastic_energy(column_.exponents, column_.spring(k), x_[k]); }
  /// Momentum that the dashpot takes back on the way to x = 0.
  Real still_to_come(std::size_t k) const { return dashpot_potential(column_.exponents, column_.dashpot(k), x_[k]); }
  Real weighted(std::size_t bead, const Real& value) const {
    return column_.mass.empty() ? value : Real(column_.mass[bead] * value);
  }
  Real per_mass(std::size_t bead, const Real& value) const {
    return column_.mass.empty() ? value : Real(value / column_.mass[bead]);
  }

  const Column<Real>& column_;
  std::span<const std::uint8_t> closed_;
  std::span<const Real> x_;
  std::vector<Real> v_;
  Real energy_{}, scale_{};
};

}  // namespace sigmasweep
