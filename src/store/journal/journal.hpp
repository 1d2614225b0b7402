#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// What a journal belongs to. A journal of another identity is never used and never overwritten silently.
struct JournalIdentity {
  std::uint64_t spec_hash = 0;
  std::uint32_t physics_version = 0;
  std::uint64_t rows = 0;
};

/// The truth while a sweep runs: an append-only file of fixed-size, checksummed records beside the table
/// (TABLE.h5.journal). One process opens it, the manager's.
class Journal {
 public:
  /// Opens what is there. Holds an exclusive fcntl lock for its lifetime, on TABLE.h5.lock, taken before anything else
  /// is opened. `fresh` replaces a journal by an empty one at once; else one of this identity is gone on with: a torn
  /// tail (from a kill or a full disk) is cut off, damaged records before it are passed over. If there is none, begin()
  /// or the first append() makes it. Throws OutputError (another process
  /// holds it; cannot be created; foreign, or of another spec, physics version or number of rows: then the file is
  /// left as it is and the message says how to go on) or IoError.
  ///
  /// With `carry` a journal of another spec, but of the same physics version and build, is not refused: carry() gets
  /// its rows and returns those that this sweep takes over, with their place in it. A journal that begins with these
  /// then replaces the old one; until it does, the old one is left as it is.
  using Carry = std::function<std::vector<Row>(const std::vector<Row>& old)>;
  Journal(const std::string& table_path, const JournalIdentity& identity, bool fresh, const Carry& carry = {});
  /// Syncs what it can, quietly, and gives the lock back.
  ~Journal();
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;

  /// Whether there is a file: an empty one is a run that was begun.
  bool is_there() const;
  /// Makes a journal of these rows where there is none; appends them to one that is there. Throws OutputError, IoError.
  void begin(const std::vector<Row>& rows);

  /// Rows found when it was opened, each index once (the last good record), in order of index. Every index is below
  /// the identity's rows; whether a row has the parameters that the spec has there is for the caller to compare.
  const std::vector<Row>& recovered() const;
  /// How many records were found damaged or torn when it was opened. Their rows are to be computed again.
  std::uint64_t dropped() const;

  /// Writes the record at once, so that a killed process loses nothing, and syncs to disk in groups: by the first
  /// append that finds a second gone or 1024 rows written since the last sync. Throws IoError naming the file and the
  /// cause (disk full); the journal then ends with its last whole record and can be gone on with. After a failed sync
  /// it stays failed: what the disk holds is unknown until it is opened again.
  void append(const Row& row);
  /// Brings everything appended to the disk. Throws IoError.
  void sync();
  /// Removes the journal, once the table is complete and checked. Nothing can be appended afterwards; the lock stays.
  void remove();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sigmasweep
