#pragma once

#include <cstdint>

namespace sigmasweep {

/// Contiguous blocks of items, one for each rank, in the order of ranks. Blocks differ by at most one item.
struct Blocks {
  std::uint64_t items, ranks;

  /// Items first, first + 1, ..., first + count - 1.
  struct Block {
    std::uint64_t first, count;
  };
  Block of(std::uint64_t rank) const;
  /// The rank whose block has the item.
  std::uint64_t owner(std::uint64_t item) const;
};

}  // namespace sigmasweep
