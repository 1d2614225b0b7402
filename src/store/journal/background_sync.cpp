#include "store/journal/background_sync.hpp"

#include <unistd.h>

#include <cerrno>

namespace sigmasweep {
namespace {

constexpr auto period = std::chrono::seconds(1);

int sync_to_disk(int fd) {
  int status = 0;
  do status = ::fdatasync(fd);
  while (status != 0 && errno == EINTR);
  return status == 0 ? 0 : errno;
}

}  // namespace

BackgroundSync::BackgroundSync(int fd)
    : fd_(fd), thread_([this](const std::stop_token& stop) { keep_syncing(stop); }) {}

BackgroundSync::~BackgroundSync() {
  thread_.request_stop();
  thread_.join();
  sync();
}

void BackgroundSync::wrote() {
  if (is_new_.exchange(true)) return;
  const std::lock_guard lock(waiting_);
  woken_.notify_one();
}

int BackgroundSync::sync() {
  const std::lock_guard lock(syncing_);
  if (failure_ == 0 && is_new_.exchange(false)) failure_ = sync_to_disk(fd_);
  return failure_;
}

void BackgroundSync::keep_syncing(const std::stop_token& stop) {
  std::unique_lock lock(waiting_);
  while (woken_.wait(lock, stop, [this] { return is_new_.load(); })) {
    woken_.wait_for(lock, stop, period, [] { return false; });
    if (stop.stop_requested()) return;  // the destructor syncs
    lock.unlock();
    if (sync() != 0) return;
    lock.lock();
  }
}

}  // namespace sigmasweep
