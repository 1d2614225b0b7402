#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// A spec to begin with: a small sweep of this geometry, and all other keys in comments, with their meaning and
/// defaults. `name`: of the file without its ending,
/// for title and comments; "beads" stands for one that is not made of letters, digits, -, _ and dots.
std::string blank_spec(Geometry geometry, const std::string& name);

}  // namespace sigmasweep
