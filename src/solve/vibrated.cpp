#include "solve/vibrated.hpp"

#include "sigmasweep/model/geometry.hpp"
#include "solve/fixed_step/stability.hpp"

namespace sigmasweep {

SimulationResult simulate_vibrated(const Parameters& parameters, ComputeBudget* budget) {
  if (parameters.method == Method::ed) return simulate_vibrated_hard_spheres(parameters, budget);
  SimulationResult c = is_lattice(parameters) ? simulate_vibrated_lattice(parameters, budget)
                                              : simulate_vibrated_soft_spheres(parameters, budget);
  if (parameters.integrator != Integrator::exact) c.predicted_growth = predicted_growth(parameters);
  return c;
}

}  // namespace sigmasweep
