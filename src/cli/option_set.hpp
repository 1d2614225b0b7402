#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sigmasweep {

/// An option or an argument of a command, as its help shows it.
struct Option {
  std::string names;                   ///< "-o,--output"; an argument, without dashes, is required
  std::string meaning;                 ///< the line in the help
  std::string type_name;               ///< the placeholder of the value, "FILE.csv"
  std::vector<std::string> choices{};  ///< the allowed values; empty: any
  std::function<std::string(const std::string& typed)> complaint{};  ///< says why a value is wrong; empty: it is valid
  bool hidden = false;                                               ///< left out of the help
};

/// The smallest and the largest value of a whole number.
struct Limits {
  std::int64_t low, high;
};

/// The form in which an option has several values.
enum class Several { arguments, repeated, comma_separated };

/// The options of one command. A command adds each option with the variable that it sets, which must exist until the
/// command line has been read.
class OptionSet {
 public:
  virtual ~OptionSet() = default;
  virtual void add(const Option& option, std::string& target) = 0;
  virtual void add(const Option& option, std::vector<std::string>& target, Several several) = 0;
  /// The present value of the target is the default, which the help shows.
  virtual void add(const Option& option, int& target, Limits limits) = 0;
  virtual void add(const Option& option, std::optional<std::uint64_t>& target, Limits limits) = 0;
  /// Calls `take` with the value; `take` returns false for text of the wrong form.
  virtual void add(const Option& option, std::function<bool(const std::string& typed)> take) = 0;
  /// An option without a value, which sets its target to `value`.
  virtual void add_flag(const std::string& names, const std::string& meaning, bool& target, bool value = true) = 0;
};

}  // namespace sigmasweep
