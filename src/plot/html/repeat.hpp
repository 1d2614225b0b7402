#pragma once

#include <string>

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep::plot {

/// The command that computes a tuple again: "sigmasweep one --v0 1 --tc 1e-05 ...", with the parameters that the tuple
/// uses and that are not as they are by default.
std::string command_of(const Parameters& parameters);

}  // namespace sigmasweep::plot
