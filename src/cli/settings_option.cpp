#include "cli/settings_option.hpp"

namespace sigmasweep {

void add_settings(OptionSet& set, std::vector<std::string>& settings) {
  set.add({.names = "--set",
           .meaning = "Replace a key of [sweep]; VALUE as in TOML, names without quotes (may be repeated)",
           .type_name = "KEY=VALUE"},
          settings, Several::repeated);
}

}  // namespace sigmasweep
