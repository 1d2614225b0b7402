#pragma once

#include <string>

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// The command line that computes a tuple again, to the bit: "sigmasweep one --v0 1 --tc 1e-05 ...". It has the
/// parameters that the tuple uses, that do not follow from others, and that are not as they are by default.
std::string repeat_command(const Parameters& parameters);

}  // namespace sigmasweep
