#include "solve/vibrated.hpp"

#include "sigmasweep/model/geometry.hpp"
#include "solve/fixed_step/stability.hpp"

namespace sigmasweep {

Collision simulate_vibrated(const Parameters& parameters, Patience* patience) {
  if (parameters.method == Method::ed) return simulate_vibrated_hard_spheres(parameters, patience);
  Collision c = is_lattice(parameters) ? simulate_vibrated_lattice(parameters, patience)
                                       : simulate_vibrated_soft_spheres(parameters, patience);
  if (parameters.integrator != Integrator::exact) c.predicted_growth = predicted_growth(parameters);
  return c;
}

}  // namespace sigmasweep
