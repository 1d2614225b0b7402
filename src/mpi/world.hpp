#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// The ranks of a run. Owns MPI (init to finalize, thread level funneled: only the thread that made the World may talk
/// to other ranks); sets the guards that the installed Open MPI needs before MPI_Init, unless the user set them.
/// Started without mpirun it is a world of one rank. If MPI runs already, it is used and left running.
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
  /// The bytes of every rank, by rank, on the manager; nothing elsewhere. Collective.
  std::vector<std::string> gather(const std::string& bytes) const;
  /// How many ranks share a processor where it is worst; at least 1. Collective.
  double crowding() const;
  /// The manager's rows dealt out as contiguous blocks in the order of ranks, `block(total)` to each. Collective.
  std::vector<Row> scatter(const std::vector<Row>& rows, std::uint64_t total) const;
  /// Rows first, first + 1, ..., first + count - 1 of `total`: this rank's block. Blocks differ by at most one row.
  struct Block {
    std::uint64_t first, count;
  };
  Block block(std::uint64_t total) const;
  /// Ends all ranks at once: for errors that this rank met alone and the others are not waiting to hear of.
  [[noreturn]] void abort(int exit_code) const;
  /// The native communicator (an MPI_Comm), for the collective table.
  void* native() const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// What the manager and the workers need to know to run a sweep.
struct Job {
  std::function<Parameters(std::uint64_t row)> tuple;  ///< on the manager
  /// Must not throw; on workers, and on a thread of the manager. A tuple that takes long asks now and then whether it
  /// is to end at once, and if so gives nothing.
  std::function<std::optional<Row>(const Tuple&, const std::function<bool()>& to_end)> compute;
  std::function<void(const Row&)> finished;  ///< on the manager, for each row as it comes in; must not throw
  std::function<bool()> stop;                ///< polled on every rank: hand out nothing more
  /// On the manager: a chunk that is predicted to take more CPU time, s, is not handed out now. Empty: no limit.
  std::function<double()> max_seconds{};
  bool manager_computes = true;
};

/// Hands out the rows of `schedule` (the manager's; unused elsewhere) and returns on all ranks when everything handed
/// out has come back. When any rank's `stop` says so, no tuple is begun any more: those in flight come back
/// if they end within half a second, the others and the rest of the chunks are dropped. A rank for which no
/// chunk is short enough gets none any more. With one rank the manager computes, whatever `job` says.
void distribute(const World& world, Schedule* schedule, const Job& job);

}  // namespace sigmasweep
