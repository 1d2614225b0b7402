#pragma once

#include <vector>

#include "assembly/column.hpp"
#include "contact/linear_pair.hpp"

namespace sigmasweep {

/// What the exact solver asks of contact k again and again. With the beads numbered from 0, bead k-1 is below contact k
/// (the wall below contact 0) and bead k above it. HasUnequalMasses: the beads have masses of their own.
template <class Real, bool HasUnequalMasses>
class ContactLaws;

/// Beads of equal mass: two laws are enough, the wall's and a pair's.
template <class Real>
class ContactLaws<Real, false> {
 public:
  explicit ContactLaws(const Column<Real>& column)
      : wall_(column.K_wall, column.C_wall, Real(1)),
        pair_(column.K, column.C, Real(2)),
        C_wall_(column.C_wall),
        C_(column.C) {}

  const BinaryContact<Real>& binary(std::size_t k) const { return k == 0 ? wall_ : pair_; }
  const Real& dashpot(std::size_t k) const { return k == 0 ? C_wall_ : C_; }
  static Real inertia(std::size_t k) { return k == 0 ? Real(1) : Real(2); }
  /// 1/m of the bead below and of the bead above; what is below contact 0 nobody asks.
  static constexpr Real below(std::size_t) { return Real(1); }
  static constexpr Real above(std::size_t) { return Real(1); }

 private:
  BinaryContact<Real> wall_, pair_;
  Real C_wall_, C_;
};

/// Each contact has a law of its own, made once.
template <class Real>
class ContactLaws<Real, true> {
 public:
  explicit ContactLaws(const Column<Real>& column) {
    for (std::size_t k = 0; k < column.contacts(); ++k) {
      inertia_.push_back(column.inertia(k));
      dashpot_.push_back(column.dashpot(k));
      above_.push_back(column.inverse_mass(k));
      binary_.emplace_back(column.spring(k), dashpot_[k], inertia_[k]);
    }
  }

  const BinaryContact<Real>& binary(std::size_t k) const { return binary_[k]; }
  const Real& dashpot(std::size_t k) const { return dashpot_[k]; }
  const Real& inertia(std::size_t k) const { return inertia_[k]; }
  Real below(std::size_t k) const { return k == 0 ? Real(0) : above_[k - 1]; }
  const Real& above(std::size_t k) const { return above_[k]; }

 private:
  std::vector<BinaryContact<Real>> binary_;
  std::vector<Real> inertia_, dashpot_, above_;
};

}  // namespace sigmasweep
