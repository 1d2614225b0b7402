#pragma once

#include <mpi.h>

#include <cstddef>
#include <span>
#include <vector>

namespace sigmasweep {

/// Sends `to_each[r]` to rank r of `comm`, for each r, and returns what the ranks have sent to this one, in the order
/// of ranks. Less than 2 GiB may leave or reach a rank. Collective.
std::vector<std::byte> exchange(MPI_Comm comm, std::span<const std::vector<std::byte>> to_each);

}  // namespace sigmasweep
