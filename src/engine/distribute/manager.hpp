#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <chrono>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "engine/distribute/byte_job.hpp"
#include "engine/distribute/dispatcher.hpp"
#include "engine/distribute/messages.hpp"
#include "engine/distribute/thread_worker.hpp"
#include "engine/stop/last_resort.hpp"
#include "mpi/world.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// Hands out the tasks of a schedule, as a Dispatcher decides, and takes back their answers.
class Manager {
 public:
  Manager(const World& world, Schedule& schedule, const ByteJob& job);
  /// Returns when every worker has delivered its last answers.
  void run();

 private:
  struct Worker {
    bool dismissed = false;  ///< was told to quit
    bool gone = false;       ///< delivered its last answers
  };
  struct Sending {
    wire::Bytes bytes;
    boost::mpi::request request;
  };

  bool look_for_messages();
  bool look_at_own_worker(std::chrono::microseconds wait);
  void take(int rank, const wire::Bytes& answers);
  void take_back(int rank, std::uint64_t tasks);
  void mark_gone(int rank);
  void copy_overdue_tasks();
  void tell_of_silent_ranks();
  void supply(int rank);
  void supply_idle();
  bool is_idle(int rank) const { return !worker_[rank].dismissed && dispatcher_.is_idle(rank); }
  void ask_for_tasks();
  void give(int rank, const Dispatcher::Tasks& tasks);
  void send(int rank, message::Tag tag, wire::Bytes bytes);
  void dismiss(int rank);
  void dismiss_all();
  void stop();

  const boost::mpi::communicator& workers_;
  const ByteJob& job_;
  std::vector<Worker> worker_;  // by rank
  Dispatcher dispatcher_;
  AwakeTime since_quit_;
  bool told_of_silent_ranks_ = false;
  int left_ = 0;                // workers that are not gone
  std::list<Sending> sending_;  // until MPI has taken them
  bool stopped_ = false;
  std::optional<ThreadWorker> own_worker_;  // last: its thread ends before the rest goes
};

}  // namespace sigmasweep
