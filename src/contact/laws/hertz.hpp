#pragma once

#include <cmath>

#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// Elastic spheres, F = K x^(3/2) + C x^gamma u, with gamma = QuarterGammas/4: 0 a linear dashpot, 1 Taguchi, 2
/// Hertz-Kuwabara-Kono. Square roots in place of powers.
template <int QuarterGammas>
struct HertzLaw {
  static_assert(QuarterGammas >= 0 && QuarterGammas <= 2);
  static constexpr bool covers(const Exponents& e) { return e.beta == 0.5 && e.gamma == 0.25 * QuarterGammas; }
  static constexpr bool costs_more_than_a_branch = false;

  explicit HertzLaw(const Exponents&) {}

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
  Real twice_elastic_energy(const Real& K, const Real& x) const {
    using std::sqrt;
    return Real(0.8) * K * x * x * sqrt(x);
  }
};

}  // namespace sigmasweep
