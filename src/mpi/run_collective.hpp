#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>

namespace sigmasweep {

/// Runs `step` on every rank of `comm` and returns the sum of the steps' results, on all ranks. If a step throws on any
/// rank, all ranks throw the error of the lowest such rank, as OutputError or IoError. If some ranks failed and others
/// have not finished half a minute later, all ranks are ended. Collective.
std::uint64_t run_collective(MPI_Comm comm, const std::function<std::uint64_t()>& step);

}  // namespace sigmasweep
