#pragma once

#include <string>

#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {

/// A parameter in one line: meaning, unit, allowed values, default, and which tuples use it.
std::string parameter_line(const ParameterField& field);

}  // namespace sigmasweep
