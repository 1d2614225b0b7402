#pragma once

#include <span>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// Many columns under the linear law at once, side by side in the lanes of vector registers, each with its own clock,
/// step and event. Results depend neither on the number of lanes nor on a column's company: they are the same to the
/// bit. See docs/physics/side-by-side.md.
namespace sigmasweep {

/// Whether a column of the linear law at a fixed wall is taken: N <= 63, and contacts that oscillate.
bool goes_side_by_side(const Parameters& parameters);

/// The results of tuples that are taken, in any order, with error bars. Status::event_limit: the tuple takes too many
/// steps and must be computed in another way. `lanes`: 1, 4 or 8, which the processor must have instructions for; 0:
/// the most that it has.
void simulate_side_by_side(std::span<const Parameters> parameters, std::span<SimulationResult> results, int lanes = 0);

}  // namespace sigmasweep
