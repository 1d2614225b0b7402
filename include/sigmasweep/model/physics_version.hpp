#pragma once

#include <cstdint>

namespace sigmasweep {

/// Number of the physics: changes whenever a change of the code may change a result.
inline constexpr std::uint32_t physics_version = 8;

}  // namespace sigmasweep
