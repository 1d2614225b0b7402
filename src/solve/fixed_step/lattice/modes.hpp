#pragma once

#include <vector>

#include "assembly/lattice.hpp"

namespace sigmasweep {

/// Coefficients of a motion x'' + c x' + k x = 0 of a lattice, for stiffness K and dashpots C and D_t of a pair of mean
/// beads: k = spring K, c = dashpot C + friction D_t.
struct ModalCoefficients {
  double spring = 0.0, dashpot = 0.0, friction = 0.0;
};

/// Coefficients of the motions with the largest spring, dashpot, friction, and dashpot + friction, in this order, while
/// all contacts are closed. Their relative error is 2 %.
std::vector<ModalCoefficients> largest_shares(const Lattice<double>& lattice);

}  // namespace sigmasweep
