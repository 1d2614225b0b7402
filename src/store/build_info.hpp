#pragma once

#include <string>

namespace sigmasweep {

/// Version and compiler of this program, which are recorded in every table.
struct BuildInfo {
  const char* program_version;  ///< the project's version
  const char* git_revision;     ///< commit, with "-dirty" if the sources differ from it; "unknown" outside git
  const char* compiler;         ///< name and version
  const char* compiler_flags;
};

const BuildInfo& build_info();

/// Program version, compiler and flags: the last digits of a result may depend on these, besides the physics version.
std::string build_name();

}  // namespace sigmasweep
