#pragma once

#include <string>

namespace sigmasweep {

/// Who says what is wrong: each process for itself, or rank 0 for all that do a command together.
enum class Speaker { each_process, rank_0 };

/// Prints a message to standard error.
void complain(const std::string& message, Speaker speaker = Speaker::each_process);

}  // namespace sigmasweep
