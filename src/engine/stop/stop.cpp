#include "engine/stop/stop.hpp"

#include <atomic>
#include <cerrno>
#include <system_error>

namespace sigmasweep {
namespace {

std::atomic<bool> signalled = false;  // the one thing a signal handler may touch
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

StopRequest::StopRequest() {
  signalled = false;
  struct sigaction action {};
  action.sa_handler = [](int) { signalled = true; };
  action.sa_flags = SA_RESTART;  // the journal's writes are not cut short
  for (std::size_t i = 0; i < signals_.size(); ++i)
    if (sigaction(signals_[i], &action, &before_[i]) != 0)
      throw std::system_error(errno, std::generic_category(), "sigaction");
}

StopRequest::~StopRequest() {
  for (std::size_t i = 0; i < signals_.size(); ++i) sigaction(signals_[i], &before_[i], nullptr);
}

void StopRequest::end_in(double seconds) {
  end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool StopRequest::made() const { return signalled || Clock::now() >= end_; }

}  // namespace sigmasweep
