#pragma once

#include <string>

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// Empty when `parameters` describe a collision; else one sentence naming the parameter, its value and what is allowed.
std::string why_invalid(const Parameters& parameters);

}  // namespace sigmasweep
