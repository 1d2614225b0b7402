#include "mpi/broadcast.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

void check_mpi(int status, const char* action) {
  if (status == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  if (MPI_Error_string(status, text.data(), &length) != MPI_SUCCESS) length = 0;
  throw IoError(fmt::format("{}: {}", action, std::string_view(text.data(), static_cast<std::size_t>(length))));
}

void broadcast_bytes(MPI_Comm comm, void* bytes, std::size_t size, int root) {
  check_mpi(MPI_Bcast(bytes, static_cast<int>(size), MPI_BYTE, root, comm), "cannot broadcast");
}

std::string broadcast(MPI_Comm comm, std::string text, int root) {
  text.resize(broadcast(comm, std::uint64_t{text.size()}, root));
  broadcast_bytes(comm, text.data(), text.size(), root);
  return text;
}

}  // namespace sigmasweep
