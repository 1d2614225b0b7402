#pragma once

#include "studies/precision/cases/precision_case.hpp"

namespace sigmasweep {

/// Lattices that fly into a wall.
PrecisionCase lattice_case(const Parameters& scene, const PrecisionSpec& spec);

}  // namespace sigmasweep
