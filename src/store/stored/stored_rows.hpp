#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "store/table/read.hpp"

namespace sigmasweep {

/// The rows of a sweep that are there, from its table, or from its journals while the sweep is not complete.
struct StoredRows {
  Table table;                                ///< of journals without columns, and its rows without parameters
  std::vector<std::uint64_t> content_keys{};  ///< of journals: those of the rows' parameters
  std::uint64_t total = 0;                    ///< rows of the sweep, or of its slice
  bool complete = true;                       ///< whether the table is written
};

/// Reads the rows of a sweep that is finished, runs, was stopped or was killed; without a lock, and without a change
/// to any file. Journals are younger than the table beside them, unless they have all rows of the same sweep, or that
/// of rank 0 is not there: then the run ended between writing the table and removing the journals. Throws as
/// read_table() and read_journal().
StoredRows read_stored_rows(const std::string& path);

}  // namespace sigmasweep
