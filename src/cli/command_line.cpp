#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/exit_codes.hpp"
#include "base/spelling.hpp"
#include "base/text/numbers.hpp"
#include "cli/complain.hpp"
#include "cli/launcher.hpp"
#include "cli/registry.hpp"
#include "cli/version.hpp"

/// The only source that includes CLI11, because its headers take long to compile.
namespace sigmasweep {
namespace {

constexpr const char* description =
    "sigmasweep computes collisions of columns and lattices of beads with a wall or a vibrating plate, for whole\n"
    "grids of parameters, on as many processes as mpirun starts.";

constexpr const char* examples = R"(
Examples:
  sigmasweep one --v0 1 --tc 2e-5 --s0 1e-6 --N 10 --epsilon 0.9     one collision, now
  sigmasweep plan fig2a.toml --ranks 8                               predicted computing time of a sweep
  sigmasweep run fig2a.toml                                          the sweep on one core -> fig2a.h5
  mpirun sigmasweep run fig2a.toml                                   the same on all cores; run it again to go on
  sigmasweep status fig2a.h5                                         how far it is, from any shell, at any time
  sigmasweep plot fig2a.h5 -o fig2a.svg                              the picture that the spec asks for
  sigmasweep show fig2a.h5 --where "sigma > 1 && method == md"       look at the table
'sigmasweep COMMAND --help' says more. Units are SI everywhere.

Exit codes: 0 all rows fine; 3 finished, but some rows have no result; 64 bad command line; 65 bad spec; 66 input not
found; 70 a bug; 73 output cannot be created; 74 I/O error; 75 stopped on purpose (run it again to go on).)";

/// Options of a command in CLI11.
class Cli11Options final : public OptionSet {
 public:
  explicit Cli11Options(CLI::App& command) : command_(command) {}

  void add(const Option& option, std::string& target) override {
    finish(option, command_.add_option(option.names, target, option.meaning));
  }

  void add(const Option& option, std::vector<std::string>& target, Several several) override {
    CLI::Option* added = command_.add_option(option.names, target, option.meaning);
    if (several == Several::repeated) added->allow_extra_args(false);
    if (several == Several::comma_separated) added->delimiter(',');
    finish(option, added);
  }

  void add(const Option& option, int& target, Limits limits) override {
    finish(option, command_.add_option(option.names, target, option.meaning)
                       ->transform(whole())
                       ->check(range(limits))
                       ->capture_default_str());
  }

  void add(const Option& option, std::optional<std::uint64_t>& target, Limits limits) override {
    finish(option, command_.add_option(option.names, target, option.meaning)->transform(whole())->check(range(limits)));
  }

  void add(const Option& option, std::function<bool(const std::string& typed)> take) override {
    const auto read = [name = option.names, take = std::move(take)](const std::string& typed) {
      if (!take(typed)) throw CLI::ValidationError(name, fmt::format("'{}' is not of the form expected", typed));
    };
    finish(option, command_.add_option_function<std::string>(option.names, read, option.meaning));
  }

  void add_flag(const std::string& names, const std::string& meaning, bool& target, bool value) override {
    if (value)
      command_.add_flag(names, target, meaning);
    else
      command_.add_flag_callback(
          names, [&target] { target = false; }, meaning);
  }

 private:
  /// Writes +3, 3.0 and 1e1 as CLI11 reads whole numbers.
  static CLI::Validator whole() {
    return {[](std::string& typed) {
              const auto number = parse_whole_number(typed);
              if (number) typed = fmt::format("{}", *number);
              return number ? "" : fmt::format("'{}' is not a whole number", typed);
            },
            ""};
  }

  static CLI::Validator range(Limits limits) { return CLI::Range(limits.low, limits.high).description(""); }

  static void finish(const Option& option, CLI::Option* added) {
    added->type_name(option.type_name);
    if (!option.names.starts_with('-')) added->required();
    if (!option.choices.empty()) added->check(CLI::IsMember(option.choices).description(""));
    if (option.complaint)
      added->check(CLI::Validator([complaint = option.complaint](std::string& typed) { return complaint(typed); }, ""));
    if (option.hidden) added->group("");
  }

  CLI::App& command_;
};

/// The message about arguments that no option takes, with the name that was probably meant.
std::string unknown_argument(const CLI::App& app) {
  const auto leftovers = app.remaining(true);
  const auto asked = app.get_subcommands();
  if (leftovers.empty()) return "a command is needed: run, plan, one, plot, show, export, ...";
  const auto option =
      std::find_if(leftovers.begin(), leftovers.end(), [](const auto& s) { return s.starts_with('-'); });
  const std::string& typed = option != leftovers.end() ? *option : leftovers.front();
  std::vector<std::string> names;
  if (option != leftovers.end())
    for (const CLI::Option* known : (asked.empty() ? &app : asked.front())->get_options())
      names.push_back(known->get_name());
  else if (asked.empty())
    for (const CLI::App* known : app.get_subcommands({})) names.push_back(known->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = nearest(typed, known);
  const char* kind = option != leftovers.end() ? "no option" : asked.empty() ? "no command" : "no use for";
  return fmt::format("there is {} '{}'{}", kind, typed, meant ? fmt::format(", did you mean '{}'?", *meant) : "");
}

/// Prints help or version to standard output, or a mistake in one line to standard error. Returns the exit code.
int explain(const CLI::App& app, const CLI::ParseError& error, Speaker speaker) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    return speaker == Speaker::each_process || launched_rank() == 0 ? app.exit(error) : 0;
  std::string command;
  for (const CLI::App* asked : app.get_subcommands()) command += asked->get_name() + " ";
  const bool unknown = !app.remaining(true).empty() || command.empty();
  std::string message = unknown ? unknown_argument(app) : error.what();
  std::ranges::replace(message, '\n', ' ');
  complain(fmt::format("{} (see sigmasweep {}--help)", message, command), speaker);
  return exit_code::usage_error;
}

}  // namespace

std::variant<Action, int> read_command_line(int argc, char** argv) {
  CLI::App app(description, "sigmasweep");
  app.footer(examples);
  app.set_version_flag("--version", version_text, "Versions of the program and its libraries");
  app.require_subcommand(1);
  std::map<const CLI::App*, Action> actions;
  for (const Command& command : commands()) {
    CLI::App* added = app.add_subcommand(std::string(command.name), std::string(command.summary));
    added->footer(command.footer);
    Cli11Options options(*added);
    actions.emplace(added, command.prepare(options));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const auto asked = app.get_subcommands();
    const bool together = !asked.empty() && is_collective(actions.at(asked.front()));
    return explain(app, error, together ? Speaker::rank_0 : Speaker::each_process);
  }
  return actions.at(app.get_subcommands().front());
}

}  // namespace sigmasweep
