#pragma once

#include <string>

namespace sigmasweep {

/// Versions of program, git revision, compiler, MPI and HDF5, a line each.
std::string version_text();

}  // namespace sigmasweep
