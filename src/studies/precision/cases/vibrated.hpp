#pragma once

#include "studies/precision/cases/precision_case.hpp"

namespace sigmasweep {

/// Columns on a plate that vibrates.
PrecisionCase vibrated_column_case(const Parameters& scene, const PrecisionSpec& spec);

/// Lattices in a container that vibrates.
PrecisionCase vibrated_lattice_case(const Parameters& scene, const PrecisionSpec& spec);

}  // namespace sigmasweep
