#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sigmasweep {

/// The order in which rows are handed out: largest predicted cost first (ties by row), in chunks of about equal cost
/// that shrink towards the end (guided self-scheduling, Polychronopoulos & Kuck 1987, in cost instead of counts).
/// A chunk takes 1/(2 ranks) of what is left, but at least `min_chunk_seconds`, so that messages cost nothing, and at
/// most `max_chunk_seconds`, so that a stop and the journal never wait long. A longer row is a chunk of its own.
class Schedule {
 public:
  /// `predicted_seconds[i]` > 0 belongs to `rows[i]`. Throws std::invalid_argument when the lengths differ, ranks < 1
  /// or a prediction is not a finite number > 0.
  Schedule(std::vector<std::uint64_t> rows, std::vector<double> predicted_seconds, int ranks,
           double min_chunk_seconds = 1e-3, double max_chunk_seconds = 0.25);
  /// Rows with the prediction, s, of each. A range over the rows; valid until the Schedule is destroyed.
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
  /// The next chunk that is predicted to take at most so long; empty when there is none. Longer rows are passed over,
  /// and looked at again after the others.
  Chunk next(double max_seconds = std::numeric_limits<double>::infinity());
  double total_seconds() const;
  double longest_seconds() const;
  /// max(total/ranks, longest): no schedule ends earlier.
  double lower_bound_seconds() const;
  /// When this schedule ends if all predictions hold: each chunk goes to the rank that is free first. Of the whole
  /// schedule, however much of it has been handed out.
  double predicted_makespan() const;

 private:
  struct Range {
    std::size_t first, end;
  };
  /// One past the last row of the chunk that begins at rows.first; takes the chunk's cost from `left`.
  std::size_t chunk_end(Range rows, double& left, double max_seconds) const;
  void pass_over(Range rows);

  std::vector<std::uint64_t> rows_;  ///< in the order of handing out
  std::vector<double> seconds_;      ///< of rows_
  Range to_do_{0, 0};                ///< to be handed out, and then
  std::vector<Range> passed_over_;   ///< these
  int ranks_;
  double min_chunk_, max_chunk_, total_ = 0.0, longest_ = 0.0, left_ = 0.0;
};

}  // namespace sigmasweep
