#pragma once

#include <cstdint>

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// The content key of a tuple: a hash of its parameters to the bit, without padding, and of the physics version.
std::uint64_t content_key(const Parameters& parameters);

}  // namespace sigmasweep
