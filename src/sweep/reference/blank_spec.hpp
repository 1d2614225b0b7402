#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// A spec to begin with: a small sweep of this geometry, and all other keys in comments, with their meaning and
/// defaults. `name`: how the table will be called, in the comments.
std::string blank_spec(Geometry geometry, const std::string& name);

}  // namespace sigmasweep
