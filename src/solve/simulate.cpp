#include "sigmasweep/solve/simulate.hpp"

#include <exception>

#include "sigmasweep/solve/exact.hpp"
#include "sigmasweep/solve/fixed_step.hpp"
#include "sigmasweep/solve/hard_spheres.hpp"

namespace sigmasweep {

Collision simulate(const Parameters& parameters) {
  try {
    if (parameters.method == Method::ed) return simulate_hard_spheres(parameters);
    if (parameters.integrator == Integrator::exact) return simulate_exact(parameters);
    return simulate_fixed_step(parameters);
  } catch (const std::exception&) {  // memory, most likely
    Collision nothing;
    nothing.status = Status::failed;
    return nothing;
  }
}

}  // namespace sigmasweep
