#pragma once

#include <ctime>

namespace sigmasweep {

/// CPU time of the calling thread, s. It measures the cost of a simulation, however many others share the processor. 0
/// where the system has no such clock; then nothing is timed and no time limit is ever reached.
inline double thread_seconds() {
  timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace sigmasweep
