#pragma once

#include <array>
#include <chrono>
#include <csignal>

namespace sigmasweep {

/// While it lives, SIGTERM, SIGINT and SIGUSR1 ask this rank to stop instead of killing it; so does the end of its
/// time, if there is one. One at a time.
class StopRequest {
 public:
  using Clock = std::chrono::steady_clock;
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Lets the time end so many seconds from now.
  void end_in(double seconds);
  bool made() const;
  Clock::time_point end() const { return end_; }

 private:
  static constexpr std::array signals_{SIGTERM, SIGINT, SIGUSR1};
  std::array<struct sigaction, signals_.size()> before_{};
  Clock::time_point end_ = Clock::time_point::max();
};

}  // namespace sigmasweep
