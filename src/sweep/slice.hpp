#pragma once

#include <cstdint>
#include <optional>

namespace sigmasweep {

/// One of `count` parts of a sweep's rows, for job arrays. Each row is in exactly one slice. Of every `count`
/// successive rows a slice has one, at a pseudo-random place, so that all slices have equal size and nearly equal cost.
/// Slice 0 of 1 is the whole sweep.
struct Slice {
  std::uint64_t index = 0, count = 1;  ///< index < count

  bool is_whole() const { return count == 1; }
  /// Number of rows of the slice, in a sweep of `total` rows; may be 0.
  std::uint64_t size(std::uint64_t total) const;
  /// The k-th row of the slice; rows ascend with k.
  std::uint64_t row(std::uint64_t k) const;
  /// The k of a row; nothing if the row is in another slice.
  std::optional<std::uint64_t> place(std::uint64_t row) const;
  /// The slice of `count` that has the row.
  static Slice with(std::uint64_t row, std::uint64_t count);

  bool operator==(const Slice&) const = default;
};

}  // namespace sigmasweep
