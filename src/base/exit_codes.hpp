#pragma once

/// Exit codes of the program: those of sysexits.h (errors.hpp has those of the user's errors), and 3 for a run some of
/// whose rows have no result. 1 is never used, because mpirun ends with it when it is interrupted itself.
namespace sigmasweep::exit_code {

constexpr int success = 0, some_rows_failed = 3, usage_error = 64, bad_data = 65, internal_error = 70, io_error = 74;
constexpr int unavailable = 69;  ///< the processor lacks instructions that the program needs
constexpr int stopped = 75;      ///< on purpose; the same command goes on

}  // namespace sigmasweep::exit_code
