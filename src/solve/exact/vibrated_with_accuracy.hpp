#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// The run of vibrated soft spheres by a scheme of order 8 with local errors of `accuracy`, in units of the plate's
/// largest speed (and that times tc). Finer or coarser than simulate(), and for columns under the linear law another
/// method.
SimulationResult vibrated_column_by_steps(const Parameters& parameters, double accuracy,
                                          ComputeBudget* budget = nullptr);
SimulationResult vibrated_lattice_by_steps(const Parameters& parameters, double accuracy,
                                           ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
