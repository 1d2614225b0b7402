#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// A table read back on one rank.
struct Table {
  TableInfo info;
  std::vector<Field> columns;  ///< what /results has
  std::vector<Row> rows;       ///< with timings; members that the file lacks keep their defaults; index: the spec's row
};

/// The rows of a table as they are asked for, so that not all of them need be in memory. What was checked when the
/// table was written, or by read_table(), is not checked again.
class TableRows {
 public:
  /// Throws as read_table().
  explicit TableRows(const std::string& path);
  ~TableRows();
  TableRows(TableRows&&) noexcept;
  TableRows& operator=(TableRows&&) = delete;

  std::uint64_t size() const;
  /// The k-th row; it reads those behind it, too. Throws IoError.
  const Row& operator[](std::uint64_t k);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads a table without MPI. Members are found by name and converted; unknown ones are passed over. Throws
/// InputNotFound, or IoError for a file that is not a whole sigmasweep table, or not any more the one that was written.
Table read_table(const std::string& path);

}  // namespace sigmasweep
