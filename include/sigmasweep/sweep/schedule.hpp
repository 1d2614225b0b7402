#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sigmasweep {

/// The order in which rows are handed out, in chunks: largest predicted cost first, chunks of about equal cost that
/// shrink towards the end, at least `min_chunk_seconds` each unless a single row is longer.
class Schedule {
 public:
  Schedule(std::vector<std::uint64_t> rows, std::vector<double> predicted_seconds, int ranks,
           double min_chunk_seconds = 1e-3);
  /// The next chunk; empty when all are handed out. Valid until the Schedule is destroyed.
  std::span<const std::uint64_t> next();
  double total_seconds() const;
  double longest_seconds() const;
  /// max(total/ranks, longest): no schedule ends earlier.
  double lower_bound_seconds() const;
  /// When this schedule ends if all predictions hold: list scheduling of its chunks.
  double predicted_makespan() const;

 private:
  std::vector<std::uint64_t> rows_;
  std::vector<double> seconds_;
  std::size_t next_ = 0;
  int ranks_;
  double min_chunk_, total_ = 0.0, longest_ = 0.0, left_ = 0.0;
};

}  // namespace sigmasweep
