#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// What the journal of a sweep holds at the moment.
struct JournalledRows {
  TableInfo info;
  std::uint64_t total = 0;  ///< rows that the finished table will have
  std::vector<Row> rows;    ///< the rows that are there, in order of index
};

/// Reads the journal beside a table (TABLE.h5.journal) without a lock, while another process may append to it, replace
/// it or remove it. Nothing if there is no journal. Throws IoError for a file that is no journal, or that this program
/// cannot read.
std::optional<JournalledRows> read_journal(const std::string& table_path);

}  // namespace sigmasweep
