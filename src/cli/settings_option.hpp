#pragma once

#include <string>
#include <vector>

#include "cli/option_set.hpp"

namespace sigmasweep {

/// Adds --set, which replaces keys of [sweep], to a command that reads a spec.
void add_settings(OptionSet& set, std::vector<std::string>& settings);

}  // namespace sigmasweep
