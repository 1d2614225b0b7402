#include "engine/stop/stop.hpp"

#include <algorithm>

namespace sigmasweep {

void StopRequest::end_in(double seconds) {
  constexpr double century = 3e9;  // the clock counts 64 bits of nanoseconds
  end_ = Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, century)));
}

bool StopRequest::made() const { return StopSignals::came() || Clock::now() >= end_; }

}  // namespace sigmasweep
