#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "base/exit_codes.hpp"
#include "cli/all_ranks.hpp"
#include "cli/command_line.hpp"
#include "cli/complain.hpp"
#include "sigmasweep/base/errors.hpp"

namespace {

using namespace sigmasweep;

/// The exit code of a run, or the code of an I/O error if its standard output could not be written.
int flushed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  complain("cannot write to standard output");
  return exit_code::io_error;
}

/// Runs an action. A command for one process does its work in every process that mpirun has started.
int perform(const Action& action, int& argc, char**& argv) {
  if (const auto* collective = std::get_if<std::function<int(World&)>>(&action))
    return on_all_ranks(argc, argv, *collective);
  return std::get<std::function<int()>>(action)();
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large becomes a failed write, whose message names the file
  Speaker speaker = Speaker::each_process;
  try {
    const auto asked = read_command_line(argc, argv);
    if (const int* code = std::get_if<int>(&asked)) return flushed(*code);
    const auto& action = std::get<Action>(asked);
    if (is_collective(action)) speaker = Speaker::rank_0;
    return flushed(perform(action, argc, argv));
  } catch (const Error& error) {
    complain(error.what(), speaker);
    return error.exit_code();
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return flushed(exit_code::success);  // fmt's error of a write that failed
    complain(fmt::format("internal error: {}", error.what()), speaker);
    return exit_code::internal_error;
  }
}
