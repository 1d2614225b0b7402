#pragma once

#include <cstddef>

#include "contact/kernels.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// A law's forces for many contacts at once, continued to overlaps x < 0 by those at 0, as a step that ends in a
/// closing or an opening needs them; contacts that are open have K = C = 0.
template <class Real>
class ContactForces {
 public:
  explicit ContactForces(Exponents e) : e_(e) {}

  void operator()(std::size_t n, const Real* K, const Real* C, const Real* x, const Real* u, Real* F) const {
    if (e_.beta == 0.5 && e_.gamma == 0.0) return each(HertzForce<0>(e_), n, K, C, x, u, F);
    if (e_.beta == 0.5 && e_.gamma == 0.25) return each(HertzForce<1>(e_), n, K, C, x, u, F);
    if (e_.beta == 0.5 && e_.gamma == 0.5) return each(HertzForce<2>(e_), n, K, C, x, u, F);
    const PowerForce power(e_);  // a power costs more than a branch
    const auto law = [&power](const Real& k, const Real& c, const Real& y, const Real& v) {
      return k == Real(0) ? Real(0) : power(k, c, y, v);
    };
    each(law, n, K, C, x, u, F);
  }

 private:
  template <class Law>
  static void each(Law law, std::size_t n, const Real* K, const Real* C, const Real* x, const Real* u, Real* F) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) F[i] = law(K[i], C[i], x[i] > 0 ? x[i] : Real(0), u[i]);
  }

  Exponents e_;
};

}  // namespace sigmasweep
