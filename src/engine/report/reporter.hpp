#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/terminal.hpp"

namespace sigmasweep {

/// Output of a run to its user. The libraries print through this object only.
class Reporter {
 public:
  using Print = std::function<void(std::string_view)>;
  /// `print` must not throw. With `quiet` only warnings are printed. On a `terminal` a line may be redrawn.
  Reporter(Print print, bool quiet, std::optional<Terminal> terminal = {}, Print print_document = {});
  static Reporter on_stderr(bool quiet);

  /// Prints "sigmasweep: MESSAGE" and ends the line, unless quiet.
  void say(std::string_view message) const;
  /// Prints a warning, "sigmasweep: MESSAGE", also if quiet.
  void warn(std::string_view message) const;
  /// Prints the text as it is, unless quiet.
  void show(std::string_view text) const;
  /// Prints a result on standard output, also when quiet.
  void document(std::string_view text) const;
  bool is_quiet() const { return quiet_; }
  bool is_terminal() const { return terminal_.has_value(); }
  int columns() const { return terminal_.value_or(Terminal{}).columns; }

 private:
  Print print_, print_document_;
  bool quiet_;
  std::optional<Terminal> terminal_;
};

}  // namespace sigmasweep
