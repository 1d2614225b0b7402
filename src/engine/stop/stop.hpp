#pragma once

#include <chrono>

#include "engine/stop/stop_signals.hpp"

namespace sigmasweep {

/// The moment in so many seconds from now; a century at most.
std::chrono::steady_clock::time_point time_in(double seconds);

/// Whether this rank is asked to stop: by a signal (StopSignals), or by the end of its time, if it has one. There may
/// be one such object at a time.
class StopRequest {
 public:
  using Clock = std::chrono::steady_clock;

  /// Sets the end of the time to so many seconds from now.
  void end_in(double seconds);
  bool made() const;
  Clock::time_point end() const { return end_; }

 private:
  StopSignals signals_;
  Clock::time_point end_ = Clock::time_point::max();
};

}  // namespace sigmasweep
