#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "cli/option_set.hpp"

namespace sigmasweep {

class World;

/// The body of a command, which returns the exit code and may throw Error. The first kind is called by one process, the
/// second by every rank of mpirun.
using Action = std::variant<std::function<int()>, std::function<int(World&)>>;

/// Whether the ranks do it together.
inline bool is_collective(const Action& action) { return std::holds_alternative<std::function<int(World&)>>(action); }

/// A command of the program. Each file in cli/commands makes one.
struct Command {
  std::string_view name;
  std::string_view summary;  ///< one line of help
  std::string footer;        ///< the help below the options
  /// Adds the options to a set. The action that is returned uses their values at the time of its call.
  std::function<Action(OptionSet&)> prepare;
};

/// A command for one process. Its options are the members of `Options`: `declare` adds them to a set, `body` takes
/// their values.
template <class Options>
Command make_command(std::string_view name, std::string_view summary, const std::string& footer,
                     void (*declare)(OptionSet&, Options&), int (*body)(const Options&)) {
  return {name, summary, footer, [declare, body](OptionSet& set) -> Action {
            const auto options = std::make_shared<Options>();
            declare(set, *options);
            return std::function<int()>([options, body] { return body(*options); });
          }};
}

/// A command for all ranks of mpirun, otherwise as above.
template <class Options>
Command make_command(std::string_view name, std::string_view summary, const std::string& footer,
                     void (*declare)(OptionSet&, Options&), int (*body)(World&, const Options&)) {
  return {name, summary, footer, [declare, body](OptionSet& set) -> Action {
            const auto options = std::make_shared<Options>();
            declare(set, *options);
            return std::function<int(World&)>([options, body](World& world) { return body(world, *options); });
          }};
}

}  // namespace sigmasweep
