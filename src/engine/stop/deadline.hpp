#pragma once

#include <chrono>
#include <map>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// The moment when computing must be over, and the longest row that can still be begun before. On the manager.
///
/// A row is expected to take its predicted time, times a factor learned from the rows done so far: their 95 % quantile
/// of run_time/predicted_time (weighted with the predicted time, as short rows say little about long ones), times the
/// number of ranks that share a processor. Before any row is done the factor is 3, the accuracy of the cost model.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;
  Deadline(Clock::time_point end, double crowding) : end_(end), crowding_(crowding) {}

  void learn(const Timing& row);
  /// Longest predicted time, s, of a row that can be begun now; negative when time is up.
  double max_seconds() const;
  double factor() const { return factor_ * crowding_; }

 private:
  void update_factor();
  Clock::time_point end_;
  double crowding_, factor_ = 3.0;
  std::map<int, double> weight_;  ///< predicted seconds by ratio, in steps of 5 %
  double total_ = 0.0, total_at_update_ = 0.0;
};

/// The part of `seconds` that is kept for writing a table of so many bytes and for the end of the job: 10 s, or a tenth
/// of `seconds` if that is less; but the time of writing, at 20 MB/s, if that is more.
double time_for_the_end(double seconds, double table_bytes);

}  // namespace sigmasweep
