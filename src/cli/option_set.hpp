#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sigmasweep {

/// An option or an argument of a command, as its help shows it.
struct Option {
  std::string names;                   ///< "-o,--output"; an argument, which has no dashes, must be given
  std::string meaning;                 ///< its line in the help
  std::string type_name;               ///< the placeholder of its value, "FILE.csv"
  std::vector<std::string> choices{};  ///< the values that may be given; empty: any
  std::function<std::string(const std::string& typed)> complaint{};  ///< says why a value is wrong; empty: it is fine
  bool hidden = false;                                               ///< another name, which the help leaves out
};

/// The smallest and the largest value of a whole number.
struct Limits {
  std::int64_t low, high;
};

/// How an option takes several values.
enum class Several { arguments, repeated, comma_separated };

/// The options of one command: a command adds its own, with the variable that each one sets. The variables must live
/// until the command line has been read.
class OptionSet {
 public:
  virtual ~OptionSet() = default;
  virtual void add(const Option& option, std::string& target) = 0;
  virtual void add(const Option& option, std::vector<std::string>& target, Several several) = 0;
  /// The help shows the number that the target has already as the default.
  virtual void add(const Option& option, int& target, Limits limits) = 0;
  virtual void add(const Option& option, std::optional<std::uint64_t>& target, Limits limits) = 0;
  /// Calls `take` with the value; it returns false for text of the wrong form.
  virtual void add(const Option& option, std::function<bool(const std::string& typed)> take) = 0;
  /// An option without a value, which sets its target to `value`.
  virtual void add_flag(const std::string& names, const std::string& meaning, bool& target, bool value = true) = 0;
};

}  // namespace sigmasweep
