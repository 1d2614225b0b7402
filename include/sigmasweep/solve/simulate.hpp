#pragma once

#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"

namespace sigmasweep {

/// Number of the physics: changes whenever a change of the code may change a result.
inline constexpr std::uint32_t physics_version = 2;

/// The collision that `parameters` describe: a pure function, the same bits for the same parameters on one build.
/// Never throws, never hangs: what cannot be computed is a status, and parameters that why_invalid() refuses are failed.
Collision simulate(const Parameters& parameters);

}  // namespace sigmasweep
