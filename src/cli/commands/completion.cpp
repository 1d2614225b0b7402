#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/option_list.hpp"
#include "cli/registry.hpp"
#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {
namespace {

/// Takes commands, words by command and option before, and words by command.
constexpr const char* bash_script = R"sh(# Completion of sigmasweep for bash: eval "$(sigmasweep completion bash)"
_sigmasweep() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words=
  if ((COMP_CWORD == 1)); then
    words='{} --help --version'
  else case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{}    *) case "${{COMP_WORDS[1]}}" in
{}    esac ;;
  esac; fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _sigmasweep sigmasweep
)sh";

/// Takes commands with their summaries, and the options of each command.
constexpr const char* zsh_script = R"sh(#compdef sigmasweep
# Completion of sigmasweep for zsh: a file _sigmasweep in a directory of $fpath.
_sigmasweep() {{
  if ((CURRENT == 2)); then
    local -a commands=({})
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{}  esac
}}
_sigmasweep "$@"
)sh";

struct CompletionOptions {
  std::string shell;
};

/// Words to choose from as the value of an option: its choices, or the names of fields.
std::vector<std::string> words_of(const ListedOption& option) {
  if (option.type_name != "CONDITION" && !option.type_name.starts_with("FIELD")) return option.choices;
  const auto names = field_names();
  return {names.begin(), names.end()};
}

std::vector<std::string> names_of(const std::vector<Command>& all) {
  std::vector<std::string> names;
  for (const Command& command : all) names.emplace_back(command.name);
  return names;
}

/// Without the signs that have a meaning between single quotes in one of the shells.
std::string plain(std::string_view given) {
  std::string text(given);
  for (const char sign : {'\'', '[', ']', ':', '\\'}) std::ranges::replace(text, sign, ' ');
  return text;
}

/// A pattern of the words before the one that is completed, and the words to choose from.
std::string bash() {
  std::string values, options;
  for (const Command& command : commands()) {
    std::vector<std::string> names;
    for (const ListedOption& option : options_of(command)) {
      const auto words = words_of(option);
      if (option.is_argument()) {
        names.insert(names.end(), words.begin(), words.end());
        continue;
      }
      names.insert(names.end(), option.names.begin(), option.names.end());
      if (!option.has_value) continue;
      for (const std::string& name : option.names)
        values += fmt::format("    '{} {}') words='{}' ;;\n", command.name, name, fmt::join(words, " "));
    }
    options += fmt::format("      {}) words='{}' ;;\n", command.name, fmt::join(names, " "));
  }
  return fmt::format(bash_script, fmt::join(names_of(commands()), " "), values, options);
}

std::string zsh() {
  std::string text, summaries;
  for (const Command& command : commands()) {
    summaries += fmt::format(" '{}:{}'", command.name, plain(command.summary));
    text += fmt::format("    {}) _arguments", command.name);
    for (const ListedOption& option : options_of(command)) {
      const auto words = words_of(option);
      const std::string action = words.empty() ? "_files" : fmt::format("({})", fmt::join(words, " "));
      if (option.is_argument()) {
        text += fmt::format(" '*:{}:{}'", option.names.front(), action);
        continue;
      }
      const std::string value = option.has_value ? fmt::format(":value:{}", action) : "";
      for (const std::string& name : option.names)
        text += fmt::format(" '{}[{}]{}'", name, plain(option.meaning), value);
    }
    text += " ;;\n";
  }
  return fmt::format(zsh_script, summaries, text);
}

std::string fish() {
  std::string text =
      "# Completion of sigmasweep for fish: ~/.config/fish/completions/sigmasweep.fish\n"
      "complete -c sigmasweep -n __fish_use_subcommand -s h -l help\n"
      "complete -c sigmasweep -n __fish_use_subcommand -l version\n";
  for (const Command& command : commands()) {
    text += fmt::format("complete -c sigmasweep -n __fish_use_subcommand -f -a {} -d '{}'\n", command.name,
                        plain(command.summary));
    for (const ListedOption& option : options_of(command)) {
      text += fmt::format("complete -c sigmasweep -n '__fish_seen_subcommand_from {}'", command.name);
      const auto words = words_of(option);
      if (!option.is_argument())
        for (const std::string& name : option.names)
          text +=
              name.starts_with("--") ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
      if (!option.is_argument() && option.has_value) text += " -r";
      if (!words.empty()) text += fmt::format(" -f -a '{}'", fmt::join(words, " "));
      text += fmt::format(" -d '{}'\n", plain(option.meaning));
    }
  }
  return text;
}

int print_completion(const CompletionOptions& options) {
  fmt::print("{}", options.shell == "bash" ? bash() : options.shell == "zsh" ? zsh() : fish());
  return 0;
}

void declare(OptionSet& set, CompletionOptions& options) {
  set.add({"shell", "The shell", "bash|zsh|fish", {"bash", "zsh", "fish"}}, options.shell);
}

}  // namespace

Command completion_command() {
  return make_command("completion", "Print a script that completes commands and options in a shell",
                      "\n  eval \"$(sigmasweep completion bash)\"        # in ~/.bashrc", declare, print_completion);
}

}  // namespace sigmasweep
