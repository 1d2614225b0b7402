#pragma once

#include <chrono>
#include <map>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// When the computing must be over, and what can still be begun before: the manager's.
///
/// A row is expected to take its predicted time, times a factor learned from the rows done so far: their 95 % quantile
/// of run_time/predicted_time (weighted with the predicted time, as short rows say little about long ones), times the
/// number of ranks that share a processor. Before there are any the factor is 3, what the cost model is good to.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;
  Deadline(Clock::time_point end, double crowding) : end_(end), crowding_(crowding) {}

  void learn(const Timing& row);
  /// Longest predicted time, s, of what can be begun now; negative when time is up.
  double max_seconds() const;
  double factor() const { return factor_ * crowding_; }

 private:
  void update_factor();
  Clock::time_point end_;
  double crowding_, factor_ = 3.0;
  std::map<int, double> weight_;  ///< predicted seconds by ratio, in steps of 5 %
  double total_ = 0.0, told_ = 0.0;
};

/// What of `seconds` is kept for writing a table of that many bytes and for the end of the job: 10 s, of less than
/// 100 s a tenth; or more if writing is predicted to take longer, at 20 MB/s.
double time_for_the_end(double seconds, double table_bytes);

}  // namespace sigmasweep
