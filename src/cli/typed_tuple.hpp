#pragma once

#include <map>
#include <string>
#include <string_view>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// Values of parameters as they were typed on the command line, by name.
using TypedParameters = std::map<std::string_view, std::string>;

/// The tuple of these parameters as a sweep of one row, so that the spec's checks and messages apply. Values are
/// numbers or names, as the parameters want. Throws UsageError, which names the help of `command`.
Sweep sweep_of(const TypedParameters& given, std::string_view command);

}  // namespace sigmasweep
