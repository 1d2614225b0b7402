#pragma once

#include <vector>

#include "sweep/dependents.hpp"
#include "sweep/grid.hpp"

namespace sigmasweep::spec {

/// Representative tuples of a sweep: one for each combination of enumerators that occurs, with the largest values of
/// the other parameters. They are enough to know which parameters a sweep uses, which depends on enumerators and on
/// whether numbers are above 0.
std::vector<Parameters> representative_tuples(const Parameters& base, const std::vector<ParameterGrid::Group>& groups,
                                              const Dependents& dependents);

}  // namespace sigmasweep::spec
