#pragma once

#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"

namespace sigmasweep {

/// Number of the physics: changes whenever a change of the code may change a result.
inline constexpr std::uint32_t physics_version = 1;

/// The collision that `parameters` describe: a pure function, the same bits for the same parameters on one build.
/// Never throws for parameters that why_invalid() accepts, never hangs: what cannot be computed is a status.
Collision simulate(const Parameters& parameters);

}  // namespace sigmasweep
