#pragma once

#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// Lines on what a spec says without words: pairs without dashpots, hard spheres whose law is not linear, time steps
/// that are too long (stability_warning()), rows that are there twice (duplicate_warning()). Of more than a million
/// rows a sample of a million is examined.
std::vector<std::string> remarks_on(const Sweep& sweep);

}  // namespace sigmasweep
