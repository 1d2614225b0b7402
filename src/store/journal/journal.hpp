#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// The sweep that a journal belongs to. A journal of another identity is never used and never overwritten silently.
struct JournalIdentity {
  std::uint64_t spec_hash = 0;
  std::uint32_t physics_version = 0;
  std::uint64_t rows = 0;
};

/// The record of a sweep while it runs: an append-only file of fixed-size, checksummed records beside the table
/// (TABLE.h5.journal). Only the manager writes it.
class Journal {
 public:
  /// Opens the journal that is there. Before anything else is opened, an exclusive fcntl lock is taken on TABLE.h5.lock
  /// and held for the lifetime of the object.
  ///
  /// `fresh` replaces a journal by an empty one at once. Otherwise a journal of this identity is continued: a torn tail
  /// (from a kill or a full disk) is cut off, damaged records before it are passed over. If there is no journal,
  /// begin() or the first append() makes it.
  ///
  /// A journal of another spec, but of the same physics version and build, is offered to `carry`: it gets the journal's
  /// rows, and what the journal says of its sweep if that can be read. carry() returns the rows that this sweep takes
  /// over, with their place in it, or nothing to have the journal refused. A journal that begins with these rows then
  /// replaces the old one; until then the old one is left as it is.
  ///
  /// Throws OutputError if another process holds the lock, if the file cannot be created, or if it is foreign or of
  /// another spec, physics version or number of rows; then the file is left as it is and the message says how to go on.
  /// Throws IoError if reading or writing fails.
  ///
  /// A journal that is made begins with `info`, for those who read it without the spec (read_journal()).
  using Carry = std::function<std::optional<std::vector<Row>>(const std::vector<Row>& old,
                                                              const std::optional<TableInfo>& theirs)>;
  ///
  /// Each good record that is there is handed to `visit`, in the order in which they were written: of several records
  /// of an index the last one counts. Every index is below the identity's rows. The caller must compare the parameters
  /// of a row with those of the spec.
  using Visit = std::function<void(const Row&)>;
  Journal(
      const std::string& table_path, const JournalIdentity& identity, bool fresh, const Carry& carry = {},
      const TableInfo& info = {}, const Visit& visit = [](const Row&) {});
  /// Syncs if possible, without an error if not, and releases the lock.
  ~Journal();
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;

  /// Whether the file system has no locks, so that a file of another kind keeps other runs away.
  bool is_locked_by_file() const;
  /// Whether there is a file. An empty journal belongs to a run that was begun.
  bool is_there() const;
  /// Makes a journal of `count` rows, or appends them to the journal that is there. Throws OutputError, IoError.
  using RowOf = std::function<Row(std::uint64_t k)>;
  void begin(std::uint64_t count, const RowOf& row);

  /// The rows that are in the file, each index once (the last good record), in order of index. It is read again.
  std::vector<Row> recovered() const;
  /// Number of records that were found damaged or torn when it was opened. Their rows must be computed again.
  std::uint64_t dropped() const;

  /// Writes the records at once, in one write, so that a killed process loses nothing. A thread brings them to the disk
  /// about a second later, so that a machine that loses its power loses the rows of the last second or two. Throws
  /// IoError naming the file and the cause (disk full); the journal then ends with its last whole record and can be
  /// continued. After a failed sync it stays failed: the content of the disk is unknown until the journal is opened
  /// again.
  void append(std::span<const Row> rows);
  void append(const Row& row) { append({&row, 1}); }
  /// Brings all appended rows to the disk. Throws IoError.
  void sync();
  /// Throws IoError if nothing can be appended any more: a sync failed meanwhile.
  void check() const;
  /// Removes the journal, once the table is complete and checked. Nothing can be appended afterwards; the lock stays.
  void remove();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sigmasweep
