#pragma once

#include <span>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// Collisions of hard spheres with a wall. In units of the gap and the speed those of equal beads with equal gaps have
/// no other parameters than N and the restitutions: tuples that have the same are computed once. The same bits for a
/// tuple alone and among others. Leaves Status::not_run where the tuple must be computed alone.
void simulate_hard_spheres_many(std::span<const Parameters> parameters, std::span<SimulationResult> results);

}  // namespace sigmasweep
