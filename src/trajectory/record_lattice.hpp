#pragma once

#include <span>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"

namespace sigmasweep {

/// record() for two dimensions.
Trajectory record_lattice(const Parameters& parameters, std::span<const double> times);

}  // namespace sigmasweep
