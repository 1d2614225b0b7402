#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sigmasweep {

/// A row to be computed, with its predicted time, s.
struct ScheduledTask {
  std::uint64_t row = 0;
  double predicted_seconds = 0.0;
  bool operator==(const ScheduledTask&) const = default;
};

/// The order in which rows are given to ranks: rows with the largest predicted time first (ties by row), in chunks that
/// shrink towards the end (guided self-scheduling, Polychronopoulos & Kuck 1987, by time instead of counts). A chunk
/// takes 1/(2 ranks) of the remaining time. It takes at least `min_chunk_seconds`, so that messages are few, and at
/// most `max_chunk_seconds`, so that stops and the journal do not wait long. A row that takes longer is a chunk of its
/// own.
class Schedule {
 public:
  /// Each row once, with a prediction > 0. Throws std::invalid_argument if ranks < 1, or a prediction is not a finite
  /// number > 0.
  Schedule(std::vector<ScheduledTask> tasks, int ranks, double min_chunk_seconds = 1e-3,
           double max_chunk_seconds = 0.25);
  /// A range of tasks. It is valid as long as the Schedule.
  using Chunk = std::span<const ScheduledTask>;
  /// The next chunk of rows that are predicted to take at most `max_seconds`; empty if there is none. Longer rows are
  /// passed over, and tried again after the others.
  Chunk next(double max_seconds = std::numeric_limits<double>::infinity());
  /// The one row of those left that is predicted to take least; empty when there is none.
  Chunk shortest();
  double total_seconds() const;
  double longest_seconds() const;
  /// max(total/ranks, longest), a lower bound of the makespan of any schedule.
  double lower_bound_seconds() const;
  /// Time from start to end of the whole schedule if all predictions hold, with each chunk on the rank that is free
  /// first.
  double predicted_makespan() const;

 private:
  struct Range {
    std::size_t first, end;
  };
  /// One past the last row of the chunk that begins at rows.first. Subtracts the chunk's time from `left`.
  std::size_t chunk_end(Range rows, double& left, double max_seconds) const;
  void pass_over(Range rows);

  std::vector<ScheduledTask> tasks_;  ///< the longest first
  Range to_do_{0, 0};                 ///< the tasks for the next chunks
  std::vector<Range> passed_over_;    ///< the tasks after these
  int ranks_;
  double min_chunk_, max_chunk_, total_ = 0.0, longest_ = 0.0, left_ = 0.0;
};

}  // namespace sigmasweep
