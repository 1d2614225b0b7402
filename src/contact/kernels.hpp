#pragma once

#include <cmath>

#include "sigmasweep/model/law.hpp"

/// The laws of a closed contact, F = K x^(1+beta) + C x^gamma u, x >= 0 its overlap and u = x' (Sec. IV B), each
/// without branches, so that loops vectorise. `elastic`: twice the elastic energy, 2 K x^(2+beta)/(2+beta).
namespace sigmasweep {

struct LinearForce {
  explicit LinearForce(const Exponents&) {}
  template <class Real>
  Real operator()(const Real& K, const Real& C, const Real& x, const Real& u) const {
    return K * x + C * u;
  }
  template <class Real>
  Real elastic(const Real& K, const Real& x) const {
    return K * x * x;
  }
};

/// beta = 1/2 and gamma = QuarterGammas/4: Hertz 0, Taguchi 1, Hertz-Kuwabara-Kono 2.
template <int QuarterGammas>
struct HertzForce {
  static_assert(QuarterGammas >= 0 && QuarterGammas <= 2);
  explicit HertzForce(const Exponents&) {}
  template <class Real>
  Real operator()(const Real& K, const Real& C, const Real& x, const Real& u) const {
    using std::sqrt;
    const Real root = sqrt(x);
    Real damping = C * u;
    if constexpr (QuarterGammas == 1) damping *= sqrt(root);
    if constexpr (QuarterGammas == 2) damping *= root;
    return K * x * root + damping;
  }
  template <class Real>
  Real elastic(const Real& K, const Real& x) const {
    using std::sqrt;
    return Real(0.8) * K * x * x * sqrt(x);
  }
};

struct PowerForce {
  explicit PowerForce(const Exponents& e) : beta(e.beta), gamma(e.gamma) {}
  template <class Real>
  Real operator()(const Real& K, const Real& C, const Real& x, const Real& u) const {
    using std::pow;
    return K * pow(x, Real(1) + Real(beta)) + C * pow(x, Real(gamma)) * u;
  }
  template <class Real>
  Real elastic(const Real& K, const Real& x) const {
    using std::pow;
    return Real(2) * K * pow(x, Real(2) + Real(beta)) / (Real(2) + Real(beta));
  }
  double beta, gamma;
};

/// The same for a contact that may be open, x <= 0: no force.
template <class Force, class Real>
Real where_closed(const Force& force, const Real& K, const Real& C, const Real& x, const Real& u) {
  return x > Real(0) ? force(K, C, x > Real(0) ? x : Real(0), u) : Real(0);
}

}  // namespace sigmasweep
