#include "store/library_versions.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>

#include "mpi/rank_group.hpp"
#include "store/hdf5/handle.hpp"

namespace sigmasweep {

std::string mpi_version() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  check_mpi(MPI_Get_library_version(text.data(), &length), "cannot ask MPI for its version");
  return text.data();
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  check(H5get_libversion(&major, &minor, &release), "cannot ask HDF5 for its version");
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace sigmasweep
