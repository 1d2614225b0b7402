#include "sigmasweep/solve/vibrated.hpp"

#include "sigmasweep/scene/plate_motion.hpp"

namespace sigmasweep {

Collision simulate_vibrated(const Parameters& parameters, Patience* patience) {
  if (is_lattice(parameters)) return simulate_vibrated_lattice(parameters, patience);
  return parameters.method == Method::ed ? simulate_vibrated_hard_spheres(parameters, patience)
                                         : simulate_vibrated_soft_spheres(parameters, patience);
}

}  // namespace sigmasweep
