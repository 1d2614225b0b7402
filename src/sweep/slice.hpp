#pragma once

#include <cstdint>
#include <optional>

namespace sigmasweep {

/// One of `count` shares of a sweep's rows, which together have each row once; for job arrays. Of every `count` rows
/// that follow each other a slice has one, at a place that changes pseudo-randomly: slices are of equal size and close
/// to equal cost whatever the axes are, and depend on nothing but the three numbers. Slice 0 of 1 is the whole sweep.
struct Slice {
  std::uint64_t index = 0, count = 1;  ///< index < count

  bool is_whole() const { return count == 1; }
  /// How many of a sweep's `total` rows it has; maybe none.
  std::uint64_t size(std::uint64_t total) const;
  /// Its k-th row; rows ascend with k.
  std::uint64_t row(std::uint64_t k) const;
  /// The k of a row, if it has it.
  std::optional<std::uint64_t> place(std::uint64_t row) const;
  /// The one of `count` slices that has this row.
  static Slice with(std::uint64_t row, std::uint64_t count);

  bool operator==(const Slice&) const = default;
};

}  // namespace sigmasweep
