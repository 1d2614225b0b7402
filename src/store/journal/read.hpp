#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "store/journal/record.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// What the journals of a sweep hold at the moment.
struct JournalledRows {
  TableInfo info;
  std::uint64_t total = 0;          ///< rows that the finished table will have
  bool has_first = true;            ///< whether rank 0's journal is among them
  std::vector<JournalledRow> rows;  ///< the rows that are there, in order of index
};

/// Reads the journals beside a table (TABLE.h5.journal and those of other ranks) without a lock, while other processes
/// may append to them, replace or remove them. Nothing if there is none. Journals that cannot be read, or that are of
/// another sweep than the first readable one, are passed over. Throws IoError if none can be read: for a file that is
/// no journal, or that this program cannot read.
std::optional<JournalledRows> read_journal(const std::string& table_path);

}  // namespace sigmasweep
