#pragma once

#include <span>

#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/solve/trajectory.hpp"

namespace sigmasweep {

/// record() for two dimensions.
Trajectory record_lattice(const Parameters& parameters, std::span<const double> times);

}  // namespace sigmasweep
