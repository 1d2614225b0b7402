#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/sweep/row.hpp"
#include "sigmasweep/sweep/schedule.hpp"

namespace sigmasweep {

/// The ranks of a run. Owns MPI (init to finalize); sets the guards that the installed Open MPI needs before MPI_Init.
class World {
 public:
  World(int& argc, char**& argv);
  ~World();
  World(const World&) = delete;
  int rank() const;
  int size() const;
  /// The same text on every rank.
  std::string broadcast(std::string text) const;
  /// The native communicator (an MPI_Comm), for the collective table.
  void* native() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What the manager and workers need to know to run a sweep; callbacks run on the manager only, `compute` on all.
struct Job {
  std::function<Parameters(std::uint64_t row)> tuple;
  std::function<Row(const Tuple&)> compute;       ///< must not throw
  std::function<void(const Row&)> finished;       ///< on the manager, for each row as it comes in
  std::function<bool()> stop;                     ///< on the manager, polled: hand out nothing more
  bool manager_computes = true;
};

/// Hands out the rows of `schedule` (used on the manager) and returns when all handed out have come back, on all ranks.
/// With one rank the same interface runs in this process.
void distribute(const World& world, Schedule* schedule, const Job& job);

}  // namespace sigmasweep
