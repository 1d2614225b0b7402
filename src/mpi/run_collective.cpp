#include "mpi/run_collective.hpp"

#include "mpi/rank_group.hpp"

namespace sigmasweep {

std::uint64_t run_collective(MPI_Comm comm, const std::function<std::uint64_t()>& step) {
  const RankGroup group(comm);
  std::uint64_t result = 0;
  group.run_collective([&] { result = step(); });
  return group.sum(result);
}

}  // namespace sigmasweep
