#pragma once

#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sweep/spec/tuples/axis.hpp"

namespace sigmasweep::spec {

/// A tuple with the values of all settings; of an axis the first one.
Parameters base_of(const std::vector<Setting>& settings);

/// Whether a parameter has a default. Others have to be given, or stand for each other: their defaults are of no use.
bool has_default(const ParameterField& field);

}  // namespace sigmasweep::spec
