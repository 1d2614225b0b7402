#pragma once

#include <stdexcept>

#include "solve/fixed_step/schemes/gear5.hpp"
#include "solve/fixed_step/schemes/leapfrog.hpp"
#include "solve/fixed_step/schemes/rk4.hpp"
#include "solve/fixed_step/schemes/scheme.hpp"
#include "solve/fixed_step/schemes/verlet.hpp"

namespace sigmasweep {

template <Scheme... Schemes>
struct SchemeList {};

/// All schemes of fixed step. Everything that depends on the scheme is made from this list.
using FixedStepSchemes = SchemeList<Gear5, Verlet, RungeKutta4, Leapfrog>;

template <class With, class First, class... Rest>
auto with_scheme_of(SchemeList<First, Rest...> /*candidates*/, Integrator integrator, With&& with) {
  if (integrator == First::id) return with.template operator()<First>();
  if constexpr (sizeof...(Rest) > 0) return with_scheme_of(SchemeList<Rest...>{}, integrator, with);
  throw std::invalid_argument("with_scheme: not an integrator of fixed step");
}

/// Calls with.operator()<Scheme>() for the integrator's scheme. Throws std::invalid_argument where it has none.
template <class With>
auto with_scheme(Integrator integrator, With&& with) {
  return with_scheme_of(FixedStepSchemes{}, integrator, with);
}

}  // namespace sigmasweep
