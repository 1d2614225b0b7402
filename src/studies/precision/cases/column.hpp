#pragma once

#include "studies/precision/cases/precision_case.hpp"

namespace sigmasweep {

/// Columns that fly into a wall.
PrecisionCase column_case(const Parameters& scene, const PrecisionSpec& spec);

}  // namespace sigmasweep
