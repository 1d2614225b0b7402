#pragma once

#include <cstddef>

#include "contact/contact_law.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// Forces of many contacts at once under a law that is not linear. They are continued to overlaps x < 0 by those at 0,
/// as a step that ends in a closing or an opening needs them; contacts that are open have K = C = 0.
template <class Real>
class ContactForces {
 public:
  explicit ContactForces(Exponents e) : e_(e) {}

  void operator()(std::size_t n, const Real* K, const Real* C, const Real* x, const Real* u, Real* F) const {
    visit_law(NonlinearLaws{}, e_, [&]<class Law>(const Law& law) {
      if constexpr (Law::costs_more_than_a_branch) {
        const auto where_any = [&law](const Real& k, const Real& c, const Real& y, const Real& v) {
          return k == Real(0) ? Real(0) : law(k, c, y, v);
        };
        each(where_any, n, K, C, x, u, F);
      } else {
        each(law, n, K, C, x, u, F);
      }
    });
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
