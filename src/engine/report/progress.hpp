#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace sigmasweep {

/// What a user sees while a sweep runs: on a terminal a bar on stderr with rows/s and time left; elsewhere a log line
/// at the start, every ten seconds and at the end. Time left comes from the predicted cost of what is done and what is
/// left, scaled by the speed measured so far, not from counts: the largest rows go first.
class Progress {
 public:
  Progress(std::uint64_t total_rows, double total_predicted_seconds, int ranks, bool quiet);
  /// `rows` more are done, which were predicted to take that long; add(0, 0) only lets the clock go on.
  void add(std::uint64_t rows, double predicted_seconds);
  void finish();

 private:
  void draw(bool last);
  double fraction() const;
  std::string state() const;
  std::uint64_t total_rows_, rows_ = 0;
  double total_seconds_, seconds_ = 0.0;
  int ranks_;
  bool quiet_, terminal_;
  std::chrono::steady_clock::time_point start_, drawn_;
};

/// A length of time as people read it: "0.3 ms", "12 s", "3 min 20 s", "5 h 12 min".
std::string readable_duration(double seconds);

}  // namespace sigmasweep
