#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/exit_codes.hpp"
#include "base/spelling.hpp"
#include "cli/command_line.hpp"
#include "cli/version.hpp"
#include "sigmasweep/base/errors.hpp"

namespace {

using namespace sigmasweep;

constexpr const char* description =
    "sigmasweep computes what columns of beads do when they hit a wall, for whole grids of parameters, on as many\n"
    "processes as mpirun gives it.";

constexpr const char* examples = R"(
Examples:
  sigmasweep one --v0 1 --tc 2e-5 --s0 1e-6 --N 10 --epsilon 0.9     one collision, now
  sigmasweep plan fig2a.toml --ranks 8                               what a sweep would take
  sigmasweep run fig2a.toml                                          the sweep on one core -> fig2a.h5
  mpirun sigmasweep run fig2a.toml                                   the same on all cores; run it again to go on
  sigmasweep plot fig2a.h5 -o fig2a.svg                              the picture that the spec asks for
  sigmasweep show fig2a.h5 --where "sigma > 1 && method == md"       look at the table
'sigmasweep COMMAND --help' says more. Units are SI everywhere.

Exit codes: 0 all rows fine; 1 finished, but some rows failed; 64 bad command line; 65 bad spec; 66 input not found;
70 a bug; 73 output cannot be created; 74 I/O error; 75 stopped on purpose (run it again to go on).)";

/// This process's rank as the launcher tells it, before (or without) MPI_Init: 0 outside of mpirun and srun.
int launched_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (const char* rank = std::getenv(name)) return std::atoi(rank);
  return 0;
}

void complain(const std::string& message) {
  if (launched_rank() == 0) fmt::print(stderr, "sigmasweep: {}\n", message);
}

/// What is wrong with an argument that nothing took, and what was probably meant.
std::string about_leftover(const CLI::App& app) {
  const auto leftovers = app.remaining(true);
  const auto asked = app.get_subcommands();
  if (leftovers.empty()) return "a command is needed: run, plan, one, plot, show, export, ...";
  const auto option =
      std::find_if(leftovers.begin(), leftovers.end(), [](const auto& s) { return s.starts_with('-'); });
  const std::string& what = option != leftovers.end() ? *option : leftovers.front();
  std::vector<std::string> names;
  if (option != leftovers.end())
    for (const CLI::Option* known : (asked.empty() ? &app : asked.front())->get_options())
      names.push_back(known->get_name());
  else if (asked.empty())
    for (const CLI::App* known : app.get_subcommands({})) names.push_back(known->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = sigmasweep::nearest(what, known);
  const char* kind = option != leftovers.end() ? "no option" : asked.empty() ? "no command" : "no use for";
  return fmt::format("there is {} '{}'{}", kind, what, meant ? fmt::format(", did you mean '{}'?", *meant) : "");
}

/// Help and version go to stdout, anything else is one line and where to read more.
int explain(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    return launched_rank() == 0 ? app.exit(error) : 0;
  std::string command;
  for (const CLI::App* asked : app.get_subcommands()) command += asked->get_name() + " ";
  const bool unknown = !app.remaining(true).empty() || command.empty();
  std::string message = unknown ? about_leftover(app) : error.what();
  for (char& c : message)
    if (c == '\n') c = ' ';
  complain(fmt::format("{} (see sigmasweep {}--help)", message, command));
  return exit_code::usage_error;
}

/// What was written to stdout is there, or we say so.
int flushed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  complain("cannot write to standard output");
  return exit_code::io_error;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is a failed write, and named
  try {
    sigmasweep::Invocation invocation{argc, argv, {}, false};
    CLI::App app(description, "sigmasweep");
    app.footer(examples);
    app.set_version_flag("--version", sigmasweep::version_text, "Versions of the program and its libraries");
    app.require_subcommand(1);
    sigmasweep::add_commands(app, invocation);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return flushed(explain(app, error));
    }
    if (!invocation.on_all_ranks && launched_rank() != 0) return 0;
    return flushed(invocation.command());
  } catch (const sigmasweep::Error& error) {
    complain(error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
    return exit_code::internal_error;
  }
}
