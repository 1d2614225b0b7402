#pragma once

#include "solve/fixed_step/schemes/step_map.hpp"

namespace sigmasweep {

/// Largest magnitude of the map's eigenvalues; infinite where an entry of the map is not finite. Error 1e-9.
double spectral_radius(const StepMap& map);

}  // namespace sigmasweep
