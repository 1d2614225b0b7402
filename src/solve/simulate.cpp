#include "sigmasweep/solve/simulate.hpp"

#include "assembly/lattice.hpp"
#include "sigmasweep/contact/law.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "solve/fixed_step/collision.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "solve/vibrated.hpp"

namespace sigmasweep {

namespace {

Collision without_result(Status status) {
  Collision nothing;
  nothing.status = status;
  return nothing;
}

Collision simulated(const Parameters& parameters, Patience* patience) {
  if (parameters.geometry == Geometry::lattice) return simulate_lattice(parameters, patience);
  if (is_vibrated(parameters)) return simulate_vibrated(parameters, patience);
  if (parameters.method == Method::ed) return simulate_hard_spheres(parameters, patience);
  if (parameters.integrator != Integrator::exact) return simulate_fixed_step(parameters, patience);
  return exponents(parameters).linear() ? simulate_exact(parameters, patience)
                                        : simulate_nonlinear(parameters, patience);
}

}  // namespace

Collision simulate(const Parameters& parameters, Patience* patience) noexcept {
  try {
    if (!why_invalid(parameters).empty()) return without_result(Status::failed);
    const Collision collision = simulated(parameters, patience);
    return patience && patience->was_over() ? without_result(Status::time_limit) : collision;
  } catch (...) {  // memory, most likely
    return without_result(Status::failed);
  }
}

}  // namespace sigmasweep
