#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace sigmasweep {

/// Brings what is written to a file to the disk, on a thread of its own: a disk that takes its time holds nobody up.
/// Bytes that are written while there is time are on the disk a second later, or as soon as the disk can.
class BackgroundSync {
 public:
  /// The descriptor stays the caller's, and open as long as the object lives.
  explicit BackgroundSync(int fd);
  /// Syncs what is left; an error is not reported any more.
  ~BackgroundSync();
  BackgroundSync(const BackgroundSync&) = delete;
  BackgroundSync& operator=(const BackgroundSync&) = delete;

  /// There are new bytes in the file.
  void wrote();
  /// Brings all bytes to the disk now. Returns 0, or the errno of this failure or an earlier one.
  int sync();
  /// The errno of the first failure; 0: none. After a failure nothing is synced any more: the kernel may have dropped
  /// the pages and forgotten the error, so that a second try could succeed without them.
  int failure() const { return failure_; }

 private:
  void keep_syncing(const std::stop_token& stop);

  int fd_;
  std::atomic<bool> is_new_ = false;
  std::atomic<int> failure_ = 0;
  std::mutex syncing_, waiting_;
  std::condition_variable_any woken_;
  std::jthread thread_;  // last: it uses all the others
};

}  // namespace sigmasweep
