#pragma once

#include <vector>

#include "sweep/grid.hpp"

namespace sigmasweep::spec {

/// The kinds of tuples that the axes make: every combination of enumerators that occurs, with zips as they are, and
/// numbers as large as they are beside it. Enough to know which parameters some tuple uses: a number counts by being
/// above 0.
std::vector<Parameters> kinds_of(const Parameters& base, const std::vector<ParameterGrid::Group>& groups);

}  // namespace sigmasweep::spec
