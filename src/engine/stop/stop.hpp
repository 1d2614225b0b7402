#pragma once

#include <array>
#include <chrono>
#include <csignal>

namespace sigmasweep {

/// Whether this rank is asked to stop. While the object lives, SIGTERM, SIGINT and SIGUSR1 ask for it instead of
/// killing the process; so does the end of its time, if it has one. There may be one such object at a time.
class StopRequest {
 public:
  using Clock = std::chrono::steady_clock;
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Sets the end of the time to so many seconds from now.
  void end_in(double seconds);
  bool made() const;
  Clock::time_point end() const { return end_; }

 private:
  static constexpr std::array signals_{SIGTERM, SIGINT, SIGUSR1};
  std::array<struct sigaction, signals_.size()> before_{};
  Clock::time_point end_ = Clock::time_point::max();
};

}  // namespace sigmasweep
