#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sigmasweep {

/// Where a run tells its user what it does. The libraries print through this object only.
class Reporter {
 public:
  /// `print` must not throw. With `quiet` only warnings are printed. `is_terminal`: whether a line may be redrawn.
  Reporter(std::function<void(std::string_view)> print, bool quiet, bool is_terminal = false);
  static Reporter on_stderr(bool quiet);

  /// Prints "sigmasweep: MESSAGE" and ends the line, unless quiet.
  void say(std::string_view message) const;
  /// The same, also when quiet: what the user must know.
  void warn(std::string_view message) const;
  /// Prints the text as it is, unless quiet.
  void show(std::string_view text) const;
  bool is_quiet() const { return quiet_; }
  bool is_terminal() const { return terminal_; }

 private:
  std::function<void(std::string_view)> print_;
  bool quiet_, terminal_;
};

}  // namespace sigmasweep
