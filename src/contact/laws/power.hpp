#pragma once

#include <cmath>

#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// Any exponents, F = K x^(1+beta) + C x^gamma u; Eq. (8).
struct PowerLaw {
  static constexpr bool covers(const Exponents&) { return true; }
  static constexpr bool costs_more_than_a_branch = true;

  explicit PowerLaw(const Exponents& e) : beta(e.beta), gamma(e.gamma) {}

  template <class Real>
  Real operator()(const Real& K, const Real& C, const Real& x, const Real& u) const {
    using std::pow;
    return K * pow(x, Real(1) + Real(beta)) + C * pow(x, Real(gamma)) * u;
  }
  /// The dashpot's part of the force.
  template <class Real>
  Real dashpot_force(const Real& C, const Real& x, const Real& u) const {
    using std::pow;
    return C * pow(x, Real(gamma)) * u;
  }
  /// K x^(2+beta)/(2+beta)
  template <class Real>
  Real elastic_energy(const Real& K, const Real& x) const {
    using std::pow;
    const Real power = Real(2.0 + beta);
    return K * Real(pow(x, power)) / power;
  }
  template <class Real>
  Real twice_elastic_energy(const Real& K, const Real& x) const {
    using std::pow;
    return Real(2) * K * pow(x, Real(2) + Real(beta)) / (Real(2) + Real(beta));
  }
  template <class Real>
  Real dashpot_potential(const Real& C, const Real& x) const {
    using std::pow;
    const Real power = Real(1) + Real(gamma);
    return C * Real(pow(x, power)) / power;
  }
  double beta, gamma;
};

}  // namespace sigmasweep
