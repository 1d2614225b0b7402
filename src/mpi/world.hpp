#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "mpi/blocks.hpp"

namespace sigmasweep {

/// The ranks of a run. Rank 0 is the manager. Owns MPI from init to finalize, at thread level funneled: only the thread
/// that made the World may talk to other ranks. Sets the guards that the installed Open MPI needs before MPI_Init,
/// unless the user set them. Started without mpirun it is a world of one rank. If MPI runs already, it is used and left
/// running.
class World {
 public:
  World(int& argc, char**& argv);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  int rank() const;
  int size() const;
  bool is_manager() const { return rank() == 0; }

  /// The manager's text, or number, on every rank. Collective.
  std::string broadcast(std::string text) const;
  std::int64_t broadcast(std::int64_t number) const;
  double broadcast(double number) const;

  /// This rank's block of `total` items.
  using Block = Blocks::Block;
  Block block(std::uint64_t total) const;
  /// The manager's items dealt out, to the bit, as contiguous blocks in the order of ranks: `block(total)` to each
  /// rank. Collective.
  template <class Item>
  requires std::is_trivially_copyable_v<Item> std::vector<Item> scatter(const std::vector<Item>& items,
                                                                        std::uint64_t total)
  const {
    std::vector<Item> mine(block(total).count);
    scatter_bytes(items.data(), mine.data(), sizeof(Item), total);
    return mine;
  }

  /// How many ranks share a processor where it is worst; at least 1. Collective.
  double crowding() const;
  /// Ends all ranks at once: for errors that this rank met alone and that the others are not waiting to hear of.
  [[noreturn]] void abort(int exit_code) const;
  MPI_Comm comm() const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  void scatter_bytes(const void* items, void* mine, std::size_t item_size, std::uint64_t total) const;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sigmasweep
