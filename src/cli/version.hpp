#pragma once

#include <string>

namespace sigmasweep {

/// Program, git revision, compiler, MPI and HDF5: a line each.
std::string version_text();

}  // namespace sigmasweep
