#include "engine/stop/stop.hpp"

namespace sigmasweep {

void StopRequest::end_in(double seconds) {
  end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool StopRequest::made() const { return StopSignals::came() || Clock::now() >= end_; }

}  // namespace sigmasweep
