#include "sigmasweep/solve/vibrated.hpp"

namespace sigmasweep {

Collision simulate_vibrated(const Parameters& parameters, Patience* patience) {
  return parameters.method == Method::ed ? simulate_vibrated_hard_spheres(parameters, patience)
                                         : simulate_vibrated_soft_spheres(parameters, patience);
}

}  // namespace sigmasweep
