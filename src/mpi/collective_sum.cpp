#include "mpi/collective_sum.hpp"

#include "mpi/collective.hpp"

namespace sigmasweep {

std::uint64_t together(MPI_Comm comm, const std::function<std::uint64_t()>& step) {
  const RankGroup team(comm);
  std::uint64_t result = 0;
  team.together([&] { result = step(); });
  return team.sum(result);
}

}  // namespace sigmasweep
