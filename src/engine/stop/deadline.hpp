#pragma once

#include <chrono>
#include <map>
#include <utility>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// What the rows that are done say of the predicted times: the 95 % quantile of run_time/predicted_time (weighted with
/// the predicted time, as short rows say little about long ones). Before any row is done it is 3, the accuracy of the
/// cost model.
class CostFactor {
 public:
  void learn(const Timing& row);
  double value() const { return factor_; }

 private:
  void update();
  double factor_ = 3.0;
  std::map<int, double> weight_;  ///< predicted seconds by ratio, in steps of 5 %
  double total_ = 0.0, total_at_update_ = 0.0;
};

/// The moment when computing must be over, and the longest row that can still be begun before. On the manager.
///
/// A row is expected to take its predicted time, times the factor learned from the rows done so far, times the number
/// of ranks that share a processor.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;
  Deadline(Clock::time_point end, double crowding, CostFactor learned = {})
      : end_(end), crowding_(crowding), learned_(std::move(learned)) {}

  void learn(const Timing& row) { learned_.learn(row); }
  /// Longest predicted time, s, of a row that can be begun now; negative when time is up.
  double max_seconds() const;
  double factor() const { return learned_.value() * crowding_; }

 private:
  Clock::time_point end_;
  double crowding_;
  CostFactor learned_;
};

/// The part of `seconds` that is kept for writing a table of so many bytes and for the end of the job: 10 s, or a tenth
/// of `seconds` if that is less; but the time of writing, at 20 MB/s, if that is more.
double time_for_the_end(double seconds, double table_bytes);

}  // namespace sigmasweep
