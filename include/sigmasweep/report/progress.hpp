#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace sigmasweep {

/// What a user sees while a sweep runs: on a terminal a bar on stderr with rows/s and time left (from predicted cost
/// done and left, not from counts); elsewhere a log line now and then.
class Progress {
 public:
  Progress(std::uint64_t total_rows, double total_predicted_seconds, int ranks, bool quiet);
  void add(std::uint64_t rows, double predicted_seconds);
  void finish();

 private:
  void draw(bool last);
  std::uint64_t total_rows_, rows_ = 0;
  double total_seconds_, seconds_ = 0.0;
  int ranks_;
  bool quiet_, terminal_;
  std::chrono::steady_clock::time_point start_, drawn_;
};

}  // namespace sigmasweep
