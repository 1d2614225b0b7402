#include "sigmasweep/solve/simulate.hpp"

#include <exception>

#include "sigmasweep/scene/law.hpp"
#include "sigmasweep/solve/exact.hpp"
#include "sigmasweep/solve/fixed_step.hpp"
#include "sigmasweep/solve/hard_spheres.hpp"
#include "sigmasweep/solve/nonlinear.hpp"

namespace sigmasweep {

namespace {

Collision without_result(Status status) {
  Collision nothing;
  nothing.status = status;
  return nothing;
}

}  // namespace

Collision simulate(const Parameters& parameters) {
  if (!why_invalid(parameters).empty()) return without_result(Status::failed);
  try {
    if (parameters.method == Method::ed) return simulate_hard_spheres(parameters);
    if (parameters.integrator == Integrator::exact)
      return exponents(parameters).linear() ? simulate_exact(parameters) : simulate_nonlinear(parameters);
    return simulate_fixed_step(parameters);
  } catch (const std::exception&) {  // memory, most likely
    return without_result(Status::failed);
  }
}

}  // namespace sigmasweep
