#include "mpi/blocks.hpp"

#include <algorithm>

namespace sigmasweep {

Blocks::Block Blocks::of(std::uint64_t rank) const {
  const std::uint64_t share = items / ranks, rest = items % ranks;
  return {rank * share + std::min(rank, rest), share + (rank < rest ? 1 : 0)};
}

std::uint64_t Blocks::owner(std::uint64_t item) const {
  const std::uint64_t share = items / ranks, rest = items % ranks, in_larger = rest * (share + 1);
  return item < in_larger ? item / (share + 1) : rest + (item - in_larger) / share;
}

}  // namespace sigmasweep
