#pragma once

/// What the program tells the shell: sysexits.h (errors.hpp has those of the user's errors), and 1 for a run whose rows
/// are not all well.
namespace sigmasweep::exit_code {

constexpr int success = 0, some_rows_failed = 1, usage_error = 64, bad_data = 65, internal_error = 70, io_error = 74;
constexpr int stopped = 75;  ///< on purpose; the same command goes on

}  // namespace sigmasweep::exit_code
