#pragma once

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

/// Reads a table without MPI. Members are found by name and converted; unknown ones are passed over. Throws
/// InputNotFound, or IoError for a file that is not a whole sigmasweep table, or not any more the one that was written.
Table read_table(const std::string& path);

}  // namespace sigmasweep
