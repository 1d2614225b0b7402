#include "sigmasweep/solve/simulate.hpp"

#include "assembly/lattice.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "solve/fixed_step/collision.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "solve/vibrated.hpp"

namespace sigmasweep {

namespace {

SimulationResult without_result(Status status) {
  SimulationResult nothing;
  nothing.status = status;
  return nothing;
}

SimulationResult simulated(const Parameters& parameters, ComputeBudget* budget) {
  if (parameters.geometry == Geometry::lattice) return simulate_lattice(parameters, budget);
  if (is_vibrated(parameters)) return simulate_vibrated(parameters, budget);
  if (parameters.method == Method::ed) return simulate_hard_spheres(parameters, budget);
  if (parameters.integrator != Integrator::exact) return simulate_fixed_step(parameters, budget);
  return exponents(parameters).linear() ? simulate_exact(parameters, budget) : simulate_nonlinear(parameters, budget);
}

}  // namespace

SimulationResult simulate(const Parameters& parameters, ComputeBudget* budget) noexcept {
  try {
    if (!why_invalid(parameters).empty()) return without_result(Status::failed);
    const SimulationResult collision = simulated(parameters, budget);
    return budget && budget->was_over() ? without_result(Status::time_limit) : collision;
  } catch (...) {  // memory, most likely
    return without_result(Status::failed);
  }
}

}  // namespace sigmasweep
