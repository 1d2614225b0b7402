#pragma once

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace sigmasweep {

/// How long to sleep between two looks for messages: longer and longer while none come, up to a millisecond, so that a
/// rank with nothing to do leaves its core to the others.
class Backoff {
 public:
  using Duration = std::chrono::microseconds;
  void reset() { next_ = shortest; }
  Duration next() { return std::exchange(next_, std::min(2 * next_, longest)); }
  void sleep() { std::this_thread::sleep_for(next()); }

 private:
  static constexpr Duration shortest{50}, longest{1000};
  Duration next_ = shortest;
};

}  // namespace sigmasweep
