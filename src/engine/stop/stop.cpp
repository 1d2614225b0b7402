#include "engine/stop/stop.hpp"

#include <algorithm>

namespace sigmasweep {

std::chrono::steady_clock::time_point time_in(double seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr double century = 3e9;  // s; the clock counts 64 bits of nanoseconds
  const std::chrono::duration<double> in(std::min(seconds, century));
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(in);
}

void StopRequest::end_in(double seconds) { end_ = time_in(seconds); }

bool StopRequest::made() const { return StopSignals::came() || Clock::now() >= end_; }

}  // namespace sigmasweep
