#pragma once

#include <vector>

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// The diameters of the beads of a tuple, m, from the wall up; of a lattice row by row. Bead i has
/// d + width (u_i - 1/2), with u_i random in [0, 1) by the seed and i, rounded to double: from here on it is a given
/// number, as d is, whatever number type computes with it. Empty if all beads are equal.
std::vector<double> diameters(const Parameters& parameters);

}  // namespace sigmasweep
