#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sigmasweep/sweep/row.hpp"

namespace sigmasweep {

/// What a journal belongs to. A journal of another identity is never used and never overwritten silently.
struct JournalIdentity {
  std::uint64_t spec_hash = 0;
  std::uint32_t physics_version = 0;
  std::uint64_t rows = 0;
};

/// The truth while a sweep runs: an append-only file of fixed-size, checksummed records beside the table
/// (TABLE.h5.journal). A torn tail (from a kill or a full disk) is cut off when it is opened again.
class Journal {
 public:
  /// Opens or creates. Holds an exclusive fcntl lock (on TABLE.h5.lock, taken before anything else is opened) for its lifetime. Throws OutputError
  /// (another live run holds it; cannot be created; of another spec or physics version unless `fresh`), IoError.
  Journal(const std::string& table_path, const JournalIdentity& identity, bool fresh);
  ~Journal();
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;

  /// Rows found when it was opened, each index once (the last good record), in order of index.
  const std::vector<Row>& recovered() const;
  /// Writes the record at once (a killed process loses nothing) and syncs to disk in groups: every second or 1024 rows. Throws IoError naming the file; after a failed sync it stays failed.
  void append(const Row& row);
  void sync();
  /// Removes the journal, once the table is complete and checked.
  void remove();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sigmasweep
