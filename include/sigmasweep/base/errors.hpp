#pragma once

#include <stdexcept>
#include <string>

/// Errors by kind. Libraries throw them; only main() turns them into a message and an exit code (sysexits).
namespace sigmasweep {

/// Base of all errors that the user can mend; `exit_code` follows sysexits.h.
class Error : public std::runtime_error {
 public:
  Error(int exit_code, const std::string& message) : std::runtime_error(message), exit_code_(exit_code) {}
  int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

struct UsageError : Error {
  explicit UsageError(const std::string& m) : Error(64, m) {}
};  ///< bad command line
struct SpecError : Error {
  explicit SpecError(const std::string& m) : Error(65, m) {}
};  ///< bad sweep spec
struct InputNotFound : Error {
  explicit InputNotFound(const std::string& m) : Error(66, m) {}
};  ///< no such input
struct OutputError : Error {
  explicit OutputError(const std::string& m) : Error(73, m) {}
};  ///< cannot be created
struct IoError : Error {
  explicit IoError(const std::string& m) : Error(74, m) {}
};  ///< read/write failed

}  // namespace sigmasweep
