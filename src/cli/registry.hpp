#pragma once

#include <vector>

#include "cli/command.hpp"

namespace sigmasweep {

/// All commands, in the order of the program's help.
std::vector<Command> commands();

}  // namespace sigmasweep
