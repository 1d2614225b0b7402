#pragma once

#include <array>
#include <chrono>
#include <csignal>

namespace sigmasweep {

/// While it lives, SIGTERM, SIGINT and SIGUSR1 ask this rank to stop instead of killing it; so does the end of
/// `max_seconds` (0: no end). One at a time.
class StopRequest {
 public:
  explicit StopRequest(double max_seconds);
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  bool made() const;

 private:
  static constexpr std::array signals_{SIGTERM, SIGINT, SIGUSR1};
  std::array<struct sigaction, signals_.size()> before_{};
  std::chrono::steady_clock::time_point end_;
};

}  // namespace sigmasweep
