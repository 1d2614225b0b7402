#pragma once

#include <string>

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// The reason why `parameters` are not valid: one sentence with a parameter, its value and the allowed values. It is
/// empty if they are valid.
std::string why_invalid(const Parameters& parameters);

}  // namespace sigmasweep
