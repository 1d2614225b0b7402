#pragma once

#include <string>

namespace sigmasweep {

/// What this program is: recorded in every table.
struct BuildInfo {
  const char* program_version;  ///< the project's version
  const char* git_revision;     ///< commit, with "-dirty" if the sources differ from it; "unknown" outside git
  const char* compiler;         ///< name and version
  const char* compiler_flags;
};

const BuildInfo& build_info();

/// What the last digits of a result may hang on, besides the physics version: program version, compiler and flags.
std::string build_name();

/// The libraries that the program runs with; both may be asked before MPI_Init.
std::string mpi_version();
std::string hdf5_version();

}  // namespace sigmasweep
