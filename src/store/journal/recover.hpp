#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/journal/record.hpp"

namespace sigmasweep {

/// The records of a journal.
struct RecoveredRecords {
  std::uint64_t records = 0;  ///< one past the last good record
  std::uint64_t dropped = 0;  ///< damaged and torn records
};

/// Reads the records of a journal, a bounded number at a time, and hands on the good ones in their order. Another
/// process may append at the same moment: a record that is not whole yet is passed over as a torn one. Throws IoError.
RecoveredRecords recover_records(const File& file, const std::string& path, const JournalHeader& header,
                                 const std::function<void(const Row&)>& visit);

/// Its rows, each index once (the last good record), in order of index.
std::vector<Row> recover_rows(const File& file, const std::string& path, const JournalHeader& header);

}  // namespace sigmasweep
