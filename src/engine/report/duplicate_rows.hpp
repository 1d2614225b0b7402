#pragma once

#include <string>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// A line for a sweep whose rows repeat tuples, as it has an axis with a value that stands there twice; empty if none
/// does. In large sweeps only the first rows are looked at.
std::string duplicate_warning(const Sweep& sweep);

}  // namespace sigmasweep
