#pragma once

#include <cstdint>
#include <string>

#include "store/table/read.hpp"

namespace sigmasweep {

/// The rows of a sweep that are there, from its table, or from its journal while the sweep is not complete.
struct StoredRows {
  Table table;              ///< of a journal without columns
  std::uint64_t total = 0;  ///< rows of the sweep, or of its slice
  bool complete = true;     ///< whether the table is written
};

/// Reads the rows of a sweep that is finished, runs, was stopped or was killed; without a lock, and without a change
/// to any file. A journal is younger than the table beside it, unless it has all rows of the same sweep: then the run
/// ended between writing the table and removing the journal. Throws as read_table() and read_journal().
StoredRows read_stored_rows(const std::string& path);

}  // namespace sigmasweep
