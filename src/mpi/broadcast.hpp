#pragma once

#include <mpi.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace sigmasweep {

/// Throws IoError, which names `action` and MPI's own reason, unless `status` is MPI_SUCCESS.
void check_mpi(int status, const char* action);

/// The first `size` bytes at `bytes` of rank `root` replace those of every other rank of `comm`. Collective.
void broadcast_bytes(MPI_Comm comm, void* bytes, std::size_t size, int root = 0);

/// Rank `root`'s value on every rank of `comm`, to the bit. Collective.
template <class Value>
requires std::is_trivially_copyable_v<Value> Value broadcast(MPI_Comm comm, Value value, int root = 0) {
  broadcast_bytes(comm, &value, sizeof value, root);
  return value;
}

/// Rank `root`'s text on every rank of `comm`. Collective.
std::string broadcast(MPI_Comm comm, std::string text, int root = 0);

}  // namespace sigmasweep
