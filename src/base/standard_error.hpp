#pragma once

#include <string_view>

namespace sigmasweep {

/// Writes text to standard error at once. A failure is ignored: that nobody can read a message (a closed terminal, a
/// full disk under the log) is no reason to end a computation.
void print_on_stderr(std::string_view text) noexcept;

}  // namespace sigmasweep
