#pragma once

#include <cstdint>
#include <hdf5.h>  // brings MPI_Comm with the parallel library
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/sweep/fields.hpp"
#include "sigmasweep/sweep/row.hpp"

namespace sigmasweep {

/// Root attributes of a table that do not follow from its rows. format, version, program, compiler and library
/// versions are added by the writer.
struct TableInfo {
  std::string title, spec_text, host, start;  ///< start: ISO 8601, UTC
  std::uint64_t spec_hash = 0;
  int ranks = 1;
};

/// Writes the table collectively: every rank of `comm` brings its contiguous block of rows, `first` being the index of
/// the block's first row. /results holds `columns`, /timings the timing fields. Goes to PATH.part, space allocated up
/// front, read back and compared by checksum, then renamed: PATH is complete or not there. Every rank returns or every
/// rank throws the same error (OutputError, IoError).
void write_table(MPI_Comm comm, const std::string& path, const TableInfo& info, std::span<const Field> columns,
                 std::uint64_t total_rows, std::uint64_t first, std::span<const Row> block);

/// A table read back on one rank.
struct Table {
  TableInfo info;
  std::vector<Field> columns;  ///< what /results has
  std::vector<Row> rows;       ///< with timings; members that the file lacks keep their defaults
};

/// Throws InputNotFound, or IoError for a file that is not a whole sigmasweep table.
Table read_table(const std::string& path);

}  // namespace sigmasweep
