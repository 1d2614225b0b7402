#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "engine/distribute/task_queue.hpp"
#include "engine/distribute/worker.hpp"

namespace sigmasweep {

/// A worker on a thread of the manager's rank. The manager itself sleeps nearly all the time, so it answers the other
/// workers at once, however long the task that is computed beside it takes.
class ThreadWorker final : private ManagerConnection {
 public:
  using Bytes = wire::Bytes;
  explicit ThreadWorker(const ByteJob& job);
  ~ThreadWorker() override;  ///< says quit and waits for the task in flight
  ThreadWorker(const ThreadWorker&) = delete;
  ThreadWorker& operator=(const ThreadWorker&) = delete;

  void give(Bytes chunk);
  /// Takes back half of the tasks that are not begun, the last ones. Returns the number.
  std::size_t take_half();
  void say_quit();
  /// Answers that were delivered since the last call.
  struct Mail {
    Bytes answers;
    bool is_last = false;  ///< nothing follows
    bool empty() const { return answers.empty() && !is_last; }
  };
  /// Waits for a delivery at most so long.
  Mail collect(std::chrono::microseconds wait);

 private:
  Bytes next_batch() override;
  void put_back(std::span<const std::byte> tasks) override;
  bool is_between_chunks() override;
  bool quit() override;
  void deliver(Bytes answers) override;
  void deliver_last(Bytes answers) override;
  void add_to_mail(Bytes answers, bool is_last);

  const ByteJob& job_;
  std::mutex mutex_;
  std::condition_variable to_worker_, to_manager_;
  TaskQueue queue_;
  Mail mail_;
  bool quit_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace sigmasweep
