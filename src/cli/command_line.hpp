#pragma once

#include <variant>

#include "cli/command.hpp"

namespace sigmasweep {

/// Reads the command line and returns the action of its command. If help, the version or a mistake ends the program,
/// prints it and returns the exit code.
std::variant<Action, int> read_command_line(int argc, char** argv);

}  // namespace sigmasweep
