#pragma once

#include <vector>

#include "sweep/grid.hpp"

namespace sigmasweep::spec {

/// Tuples that stand for all that the axes make: one for every combination of enumerators that occurs, with zips as
/// they are, and the largest numbers beside it. Enough to know which parameters some tuple uses: a number counts by
/// being above 0.
std::vector<Parameters> representative_tuples(const Parameters& base, const std::vector<ParameterGrid::Group>& groups);

}  // namespace sigmasweep::spec
