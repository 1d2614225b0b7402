#include "cli/registry.hpp"

/// The commands in the order of the program's help. commands/NAME.cpp defines NAME_command().
// clang-format off
#define SIGMASWEEP_COMMANDS(X) \
  X(run) \
  X(merge) \
  X(precision) \
  X(stability) \
  X(plan) \
  X(one) \
  X(advise) \
  X(plot) \
  X(report) \
  X(status) \
  X(show) \
  X(export) \
  X(new) \
  X(help) \
  X(schema) \
  X(completion) \
  /* a line for each */
// clang-format on

namespace sigmasweep {

#define SIGMASWEEP_DECLARE(name) Command name##_command();
SIGMASWEEP_COMMANDS(SIGMASWEEP_DECLARE)

std::vector<Command> commands() {
#define SIGMASWEEP_MAKE(name) name##_command(),
  return {SIGMASWEEP_COMMANDS(SIGMASWEEP_MAKE)};
}

}  // namespace sigmasweep
