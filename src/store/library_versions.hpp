#pragma once

#include <string>

namespace sigmasweep {

/// Versions of the libraries that the program runs with. May be called before MPI_Init.
std::string mpi_version();
std::string hdf5_version();

}  // namespace sigmasweep
