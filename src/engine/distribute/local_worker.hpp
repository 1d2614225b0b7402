#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/distribute/worker.hpp"

namespace sigmasweep {

/// A worker on a thread of the manager's rank. The manager itself sleeps nearly all the time, so it answers the other
/// workers at once however long the tuple that is computed beside it takes.
class LocalWorker final : private Line {
 public:
  explicit LocalWorker(const Compute& compute);
  ~LocalWorker() override;  ///< says quit and waits for the tuple in flight
  LocalWorker(const LocalWorker&) = delete;
  LocalWorker& operator=(const LocalWorker&) = delete;

  void give(std::vector<Tuple> chunk);
  void say_quit();
  /// What has been delivered since, after waiting for it at most this long.
  struct Mail {
    std::vector<Row> rows;
    bool farewell = false;  ///< nothing follows
  };
  Mail collect(std::chrono::microseconds wait);

 private:
  std::vector<Tuple> next_chunk() override;
  bool quit() override;
  void deliver(std::vector<Row> rows) override;
  void farewell(std::vector<Row> rows) override;

  std::mutex mutex_;
  std::condition_variable to_worker_, to_manager_;
  std::deque<std::vector<Tuple>> chunks_;
  Mail mail_;
  bool quit_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace sigmasweep
