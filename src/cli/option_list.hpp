#pragma once

#include <vector>

#include "cli/command.hpp"

namespace sigmasweep {

/// An option as shells complete it.
struct ListedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; of an argument its name, without dashes
  std::string meaning, type_name;
  std::vector<std::string> choices;
  bool has_value = true;
  bool is_argument() const { return names.front().front() != '-'; }
};

/// The options and arguments of a command that its help shows.
std::vector<ListedOption> options_of(const Command& command);

}  // namespace sigmasweep
