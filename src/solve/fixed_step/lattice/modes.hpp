#pragma once

#include <vector>

#include "assembly/lattice.hpp"

namespace sigmasweep {

/// What springs, dashpots and tangential dashpots do to a motion of a lattice, per mean mass and over those of a pair
/// of mean beads: in x'' + c x' + k x = 0 k = spring K, c = dashpot C + friction D_t.
struct ModalCoefficients {
  double spring = 0.0, dashpot = 0.0, friction = 0.0;
};

/// Of the motions, all contacts closed, for which each of these is largest, and dashpot + friction. To 2 %.
std::vector<ModalCoefficients> largest_shares(const Lattice<double>& lattice);

}  // namespace sigmasweep
