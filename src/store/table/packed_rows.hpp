#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// Rows as the bytes that a table has of them: the columns of /results, and the timings. They take a third of the
/// memory of Rows, can be sent between ranks as they are, and are written as they are.
class PackedRows {
 public:
  /// So many rows with Status::not_run.
  PackedRows(std::span<const Field> columns, std::uint64_t rows);
  /// A block of rows that are there.
  PackedRows(std::span<const Field> columns, std::span<const Row> rows);

  std::uint64_t size() const { return rows_; }
  void set(std::uint64_t k, const Row& row);
  /// Sets the columns and timings of `row`; all other members stay as they are.
  void get(std::uint64_t k, Row& row) const;

  /// All rows of one dataset of the table.
  struct Section {
    std::vector<Field> fields;
    std::size_t row_size;  ///< bytes
    std::vector<std::byte> bytes{};

    Section(std::span<const Field> fields, std::uint64_t rows);
    std::byte* at(std::uint64_t k) { return bytes.data() + k * row_size; }
    const std::byte* at(std::uint64_t k) const { return bytes.data() + k * row_size; }
  };
  Section& results() { return results_; }
  Section& timings() { return timings_; }
  const Section& results() const { return results_; }
  const Section& timings() const { return timings_; }

 private:
  std::uint64_t rows_;
  Section results_, timings_;
};

/// A contiguous block of a table's rows: the bytes of each dataset.
struct PackedBlock {
  std::uint64_t first;  ///< place of its first row in the table
  std::uint64_t rows;
  std::array<std::span<const std::byte>, 2> sections;  ///< results, timings

  /// The first so many of the packed rows.
  PackedBlock(std::uint64_t first, const PackedRows& packed, std::uint64_t rows);
};

/// A contiguous block of a table's rows that comes in pieces, so that not all of it need be in memory.
struct BlockInPieces {
  std::uint64_t first, rows;
  std::uint64_t pieces = 1;  ///< the same on all ranks; some may have no rows
  /// Makes the next piece, which follows the one before; it is valid until the next call. All ranks call it together,
  /// so many times; it throws on all or on none.
  std::function<PackedBlock()> next;

  BlockInPieces(std::uint64_t first, std::uint64_t rows, std::uint64_t pieces, std::function<PackedBlock()> next);
  /// A block in one piece.
  BlockInPieces(const PackedBlock& whole);
};

}  // namespace sigmasweep
