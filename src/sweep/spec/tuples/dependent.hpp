#pragma once

#include <vector>

#include "sweep/dependents.hpp"
#include "sweep/grid.hpp"
#include "sweep/spec/tuples/axis.hpp"

namespace sigmasweep::spec {

/// The parameters that are expressions of others, in an order in which each comes after those that it uses. Checks the
/// values of all tuples, and makes the axis of each setting the ends of its values. Throws SpecError for a mistake in
/// an expression, a circle, a parameter that is neither given nor has a default, and a value that is not allowed.
Dependents read_dependents(std::vector<Setting>& settings, const std::vector<ParameterGrid::Group>& groups);

}  // namespace sigmasweep::spec
