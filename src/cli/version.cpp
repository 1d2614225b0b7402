#include "cli/version.hpp"

#include <fmt/format.h>

#include "store/build_info.hpp"
#include "store/library_versions.hpp"

namespace sigmasweep {

std::string version_text() {
  const BuildInfo& build = build_info();
  const std::string mpi = mpi_version();
  return fmt::format("sigmasweep {}\nrevision   {}\ncompiler   {} {}\nMPI        {}\nHDF5       {}",
                     build.program_version, build.git_revision, build.compiler, build.compiler_flags,
                     mpi.substr(0, mpi.find_first_of(",\n")), hdf5_version());
}

}  // namespace sigmasweep
