#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace sigmasweep {

struct Invocation {
  int& argc;
  char**& argv;
  std::function<int()> command;  ///< set when the line is parsed: what was asked for
  bool on_all_ranks = false;     ///< likewise: whether it is for all ranks of mpirun, or for one
};

/// The commands with their options and help.
void add_commands(CLI::App& app, Invocation& invocation);

}  // namespace sigmasweep
