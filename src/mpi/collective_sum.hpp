#pragma once

#include <mpi.h>  // brings MPI_Comm with the parallel library
#include <cstdint>
#include <functional>

namespace sigmasweep {

/// Does `step` on every rank of `comm` and returns the sum of what the steps return, on all ranks. If it threw on any
/// rank, all ranks throw the error of the lowest such rank, as OutputError or IoError; if the others do not come to
/// hear of it within half a minute, all ranks are ended. Collective.
std::uint64_t together(MPI_Comm comm, const std::function<std::uint64_t()>& step);

}  // namespace sigmasweep
