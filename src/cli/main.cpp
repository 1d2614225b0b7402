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

/// Runs an action. If mpirun has started several processes, rank 0 runs a command for one process.
int perform(const Action& action, int& argc, char**& argv) {
  if (const auto* collective = std::get_if<std::function<int(World&)>>(&action))
    return on_all_ranks(argc, argv, *collective);
  return launched_rank() == 0 ? std::get<std::function<int()>>(action)() : exit_code::success;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large becomes a failed write, whose message names the file
  try {
    const auto asked = read_command_line(argc, argv);
    if (const int* code = std::get_if<int>(&asked)) return flushed(*code);
    return flushed(perform(std::get<Action>(asked), argc, argv));
  } catch (const Error& error) {
    complain(error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
    return exit_code::internal_error;
  }
}
