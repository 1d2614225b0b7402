#pragma once

#include <cmath>
#include <cstddef>

#include "sigmasweep/scene/law.hpp"

namespace sigmasweep {

/// F = K x^(1+beta) + C x^gamma u for many contacts at once; contacts that are open have K = C = 0. Sec. IV B.
template <class Real>
class PowerForce {
 public:
  explicit PowerForce(Exponents e) : e_(e) {
    if (e.beta == 0.5 && e.gamma == 0.0) kind_ = Kind::hertz;
    if (e.beta == 0.5 && e.gamma == 0.5) kind_ = Kind::hertz_kuwabara_kono;
    if (e.beta == 0.5 && e.gamma == 0.25) kind_ = Kind::taguchi;
  }

  void operator()(std::size_t n, const Real* K, const Real* C, const Real* x, const Real* u, Real* F) const {
    using std::pow, std::sqrt;
    switch (kind_) {
      case Kind::hertz:
        return each(n, K, C, x, u, F, [](Real k, Real c, Real y, Real v) { return k * y * sqrt(y) + c * v; });
      case Kind::hertz_kuwabara_kono:
        return each(n, K, C, x, u, F, [](Real k, Real c, Real y, Real v) { return sqrt(y) * (k * y + c * v); });
      case Kind::taguchi:
        return each(n, K, C, x, u, F, [](Real k, Real c, Real y, Real v) {
          const Real r = sqrt(y);
          return k * y * r + c * sqrt(r) * v;
        });
      case Kind::power: break;
    }
    const Real beta(e_.beta), gamma(e_.gamma);
    each(n, K, C, x, u, F, [beta, gamma](Real k, Real c, Real y, Real v) {
      return k == Real(0) ? Real(0) : Real(k * y * pow(y, beta) + c * pow(y, gamma) * v);
    });
  }

 private:
  enum class Kind { hertz, hertz_kuwabara_kono, taguchi, power };

  template <class Law>
  static void each(std::size_t n, const Real* K, const Real* C, const Real* x, const Real* u, Real* F, Law law) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) F[i] = law(K[i], C[i], x[i] > 0 ? x[i] : Real(0), u[i]);
  }

  Exponents e_;
  Kind kind_ = Kind::power;
};

}  // namespace sigmasweep
