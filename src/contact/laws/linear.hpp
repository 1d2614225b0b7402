#pragma once

#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// Linear spring and dashpot, F = K x + C u; Eqs. (2), (3).
struct LinearLaw {
  static constexpr bool covers(const Exponents& e) { return e.beta == 0.0 && e.gamma == 0.0; }
  static constexpr bool costs_more_than_a_branch = false;

  explicit LinearLaw(const Exponents&) {}

  template <class Real>
  Real operator()(const Real& K, const Real& C, const Real& x, const Real& u) const {
    return K * x + C * u;
  }
  template <class Real>
  Real twice_elastic_energy(const Real& K, const Real& x) const {
    return K * x * x;
  }
  template <class Real>
  Real dashpot_potential(const Real& C, const Real& x) const {
    return C * x;
  }
};

}  // namespace sigmasweep
