#pragma once

#include <type_traits>

#include "assembly/column.hpp"
#include "contact/contact_law.hpp"
#include "solve/fixed_step/schemes/scheme_list.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace sigmasweep {

/// While it lives denormal numbers are zero. High derivatives fade to them in free flight, and with them the processor
/// is about twenty times slower.
class DenormalsAreZero {
#if defined(__SSE2__)
 public:
  DenormalsAreZero() { _mm_setcsr(before_ | 0x8040u); }  // flush to zero, denormals are zero
  ~DenormalsAreZero() { _mm_setcsr(before_); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
#endif
};

/// Calls with.operator()<Force, Uneven>() for the column's law. Beads of equal mass have a kernel of their own with the
/// linear law; with the others they are no special case.
template <class With>
auto with_law(const Column<double>& column, With&& with) {
  return visit_law(column.exponents, [&]<class Law>(const Law&) {
    if constexpr (std::is_same_v<Law, LinearLaw>)
      if (column.is_uniform()) return with.template operator()<Law, false>();
    return with.template operator()<Law, true>();
  });
}

/// Calls with.operator()<Force, Uneven, Scheme>() for the column's law and the integrator, denormal numbers being zero
/// meanwhile. Throws std::invalid_argument where the integrator has no fixed step.
template <class With>
auto with_law_and_scheme(const Column<double>& column, Integrator integrator, With&& with) {
  return with_law(column, [&]<class Force, bool Uneven>() {
    const DenormalsAreZero guard;
    return with_scheme(integrator, [&]<class Scheme>() { return with.template operator()<Force, Uneven, Scheme>(); });
  });
}

}  // namespace sigmasweep
