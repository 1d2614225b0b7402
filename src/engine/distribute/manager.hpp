#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <chrono>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "engine/distribute/byte_job.hpp"
#include "engine/distribute/messages.hpp"
#include "engine/distribute/tasks_out.hpp"
#include "engine/distribute/thread_worker.hpp"
#include "engine/stop/last_resort.hpp"
#include "mpi/world.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// Hands out the tasks of a schedule, largest first, and takes back their answers.
///
/// A worker whose chunk is short has the next chunk waiting beside it, so that it never waits for the manager. Behind a
/// long chunk (prefetch_seconds) nothing waits: compared with it the manager's reply is instant, and a second long
/// chunk in the same queue would leave the other ranks idle at the end.
class Manager {
 public:
  Manager(const World& world, Schedule& schedule, const ByteJob& job);
  /// Returns when every worker has delivered its last answers.
  void run();

 private:
  struct Worker {
    std::uint64_t last_chunk_tasks = 0;
    double last_chunk_seconds = 0.0;  ///< predicted
    bool dismissed = false;           ///< was told to quit
    bool gone = false;                ///< delivered its last answers
  };
  struct Sending {
    wire::Bytes bytes;
    boost::mpi::request request;
  };

  bool look_for_messages();
  bool look_at_own_worker(std::chrono::microseconds wait);
  void take(int rank, const wire::Bytes& answers);
  void mark_gone(int rank);
  void copy_overdue_tasks();
  void tell_of_silent_ranks();
  void supply(int rank);
  void supply_idle();
  bool wants_chunk(int rank) const;
  void hand_out(int rank, const Schedule::Chunk& piece);
  void send(int rank, message::Tag tag, wire::Bytes bytes);
  void dismiss(int rank);
  void dismiss_all();
  void stop();
  Schedule::Chunk next_piece();
  Schedule::Chunk next_chunk();

  const boost::mpi::communicator& workers_;
  Schedule& schedule_;
  const ByteJob& job_;
  std::vector<Worker> worker_;  // by rank
  TasksOut out_;
  AwakeTime since_quit_;
  bool told_of_silent_ranks_ = false;
  int left_ = 0;                // workers that are not gone
  Schedule::Chunk piece_;       // of the schedule's chunk, still to be handed out
  std::list<Sending> sending_;  // until MPI has taken them
  bool stopped_ = false;
  bool handed_out_ = false;                 // anything at all
  std::optional<ThreadWorker> own_worker_;  // last: its thread ends before the rest goes
};

}  // namespace sigmasweep
