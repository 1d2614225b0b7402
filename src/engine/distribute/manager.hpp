#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <cstdint>
#include <list>
#include <optional>
#include <span>
#include <vector>

#include "engine/distribute/local_worker.hpp"
#include "mpi/world.hpp"

namespace sigmasweep {

/// Hands out the rows of a schedule, largest first, and takes back what comes of them.
///
/// A worker whose chunk is short has the next one waiting beside it, so that it never waits for an answer. Behind a
/// long one (prefetch_seconds) nothing waits: the answer takes no time against it, and a second long chunk in the same
/// queue would leave the other ranks idle at the end.
class Manager {
 public:
  Manager(const World& world, Schedule& schedule, const Job& job);
  /// Until every worker has said farewell.
  void run();

 private:
  struct Worker {
    std::uint64_t rows_out = 0;  ///< handed out, not back yet
    std::uint64_t last_chunk_rows = 0;
    double last_chunk_seconds = 0.0;  ///< predicted
    bool dismissed = false, gone = false;
  };
  struct Sending {
    std::vector<Tuple> tuples;
    boost::mpi::request request;
  };

  bool look_for_messages();
  bool look_at_own_worker(std::chrono::microseconds wait);
  void take(int rank, const std::vector<Row>& rows);
  void farewell(int rank);
  void supply(int rank);
  bool wants_chunk(const Worker& worker) const;
  void hand_out(int rank, std::span<const std::uint64_t> rows);
  void dismiss(int rank);
  void dismiss_all();
  void stop();
  std::span<const std::uint64_t> next_piece();

  const boost::mpi::communicator& workers_;
  Schedule& schedule_;
  const Job& job_;
  std::vector<Worker> worker_;            // by rank
  int left_ = 0;                          // workers that have not said farewell
  std::span<const std::uint64_t> piece_;  // of the schedule's chunk, still to be handed out
  std::list<Sending> sending_;            // until MPI has taken them
  bool stopped_ = false;
  std::optional<LocalWorker> own_worker_;  // last: its thread ends before the rest goes
};

}  // namespace sigmasweep
