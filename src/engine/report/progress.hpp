#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "engine/report/reporter.hpp"
#include "store/run_notes/run_notes.hpp"

namespace sigmasweep {

/// Says how many rows a run has to compute: before their times are predicted, which may take some seconds.
void announce(const Reporter& reporter, std::uint64_t rows, int ranks);

/// The progress of a run: on a terminal a bar with rows/s and time left; elsewhere a log line at the start, before the
/// first second is over, every ten seconds and at the end. Time left is that of the part that is left at the speed so
/// far. The part is the mean of that of the rows and that of their predicted cost: counts alone are wrong because the
/// largest rows go first, and costs alone where the predictions are.
class Progress {
 public:
  Progress(std::uint64_t total_rows, double total_predicted_seconds, Reporter reporter);
  /// So many more rows are done, which were predicted to take that long; add(0, 0) only lets the clock go on.
  void add(std::uint64_t rows, double predicted_seconds);
  void finish();
  RunProgress now() const;

 private:
  bool is_due() const;
  void draw(bool last);
  double fraction() const;
  std::string state() const;
  std::uint64_t total_rows_, rows_ = 0;
  double total_seconds_, seconds_ = 0.0;
  Reporter reporter_;
  std::chrono::steady_clock::time_point start_, drawn_;
  bool is_first_ = true;  ///< no log line was written yet
};

}  // namespace sigmasweep
