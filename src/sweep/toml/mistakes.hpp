#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::spec {

/// The messages about a spec that is not a file of the user's, without the places in it: "s0 = -1: why" of
/// "FILE:3: sweep.s0 = -1: why".
std::string without_places(const std::string& messages, std::string_view file);

/// The mistakes of a spec, which are reported together.
class Mistakes {
 public:
  /// Calls `read` and keeps the message of the SpecError that it throws.
  template <class Read>
  void keep(Read&& read) {
    try {
      read();
    } catch (const SpecError& error) {
      add(error.what());
    }
  }
  /// A message may have several lines, a mistake each.
  void add(const std::string& message);
  bool are_there() const { return !lines_.empty(); }
  /// Throws a SpecError with the messages, a line each, if there are mistakes. Beyond `most` lines it says how many
  /// more.
  void refuse_any(std::size_t most = SIZE_MAX) const;
  static constexpr std::size_t readable = 20;  ///< a number of lines for people

 private:
  std::vector<std::string> lines_;
  std::set<std::string> lists_;
};

}  // namespace sigmasweep::spec
