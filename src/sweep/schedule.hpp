#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sigmasweep {

/// The order in which rows are given to ranks: rows with the largest predicted time first (ties by row), in chunks that
/// shrink towards the end (guided self-scheduling, Polychronopoulos & Kuck 1987, by time instead of counts). A chunk
/// takes 1/(2 ranks) of the remaining time. It takes at least `min_chunk_seconds`, so that messages are few, and at
/// most `max_chunk_seconds`, so that stops and the journal do not wait long. A row that takes longer is a chunk of its
/// own.
class Schedule {
 public:
  /// `predicted_seconds[i]` > 0 is the prediction for `rows[i]`. Throws std::invalid_argument if the lengths differ,
  /// ranks < 1, or a prediction is not a finite number > 0.
  Schedule(std::vector<std::uint64_t> rows, std::vector<double> predicted_seconds, int ranks,
           double min_chunk_seconds = 1e-3, double max_chunk_seconds = 0.25);
  /// A range of rows with their predictions, s. It is valid as long as the Schedule.
  struct Chunk {
    std::span<const std::uint64_t> rows;
    std::span<const double> predicted_seconds;
    std::size_t size() const { return rows.size(); }
    bool empty() const { return rows.empty(); }
    auto begin() const { return rows.begin(); }
    auto end() const { return rows.end(); }
    Chunk first(std::size_t count) const { return {rows.first(count), predicted_seconds.first(count)}; }
    Chunk from(std::size_t row) const { return {rows.subspan(row), predicted_seconds.subspan(row)}; }
  };
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

  std::vector<std::uint64_t> rows_;  ///< the longest first
  std::vector<double> seconds_;      ///< predictions for rows_
  Range to_do_{0, 0};                ///< the rows for the next chunks
  std::vector<Range> passed_over_;   ///< the rows after these
  int ranks_;
  double min_chunk_, max_chunk_, total_ = 0.0, longest_ = 0.0, left_ = 0.0;
};

}  // namespace sigmasweep
