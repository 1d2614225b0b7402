#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "store/journal/file.hpp"
#include "store/journal/recover.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// The record of a sweep while it runs: journals beside the table, one of each rank (names.hpp). This object is the
/// manager's. It has the lock, reads the journals of all ranks when it opens, and writes that of rank 0.
///
/// The journals are one set, whatever the number of ranks that wrote them: a row counts wherever it stands. One that is
/// missing or damaged costs its rows only.
class Journal {
 public:
  /// Opens the journals that are there. Before anything else is opened, an exclusive fcntl lock is taken on
  /// TABLE.h5.lock and held for the lifetime of the object.
  ///
  /// `fresh` replaces the journals by an empty one at once. Otherwise journals of this identity are continued: a torn
  /// tail (from a kill or a full disk) is cut off, damaged records before it are passed over. If there is none, begin()
  /// or the first append() makes it. Journals of format 2 are rewritten in the present one.
  ///
  /// Journals of another spec, but of the same physics version and build, are offered to `carry`: it gets their rows,
  /// and what rank 0's journal says of its sweep if that can be read. carry() returns the rows that this sweep takes
  /// over, with their place in it, or nothing to have the journals refused. A journal that begins with these rows then
  /// replaces the old ones; until then they are left as they are.
  ///
  /// Throws OutputError if another process holds the lock, if the file cannot be created, or if it is foreign or of
  /// another spec, physics version or number of rows; then the file is left as it is and the message says how to go on.
  /// Journals of other ranks do so only where rank 0's is missing; beside it they are passed over, as is rank 0's where
  /// its header is damaged. Throws IoError if reading or writing fails.
  ///
  /// A journal that is made begins with `info`, for those who read it without the spec (read_journal()).
  using Carry = std::function<std::optional<std::vector<Row>>(const std::vector<JournalledRow>& old,
                                                              const std::optional<TableInfo>& theirs)>;
  ///
  /// Each good record that is there is handed to `visit`, in the order in which they were written in each journal; of
  /// several records of an index one counts (precedence_of()). Every index is below the identity's rows. The caller
  /// must compare the content key of a row with that of the spec's.
  using Visit = RecordReader::Visit;
  Journal(
      const std::string& table_path, const JournalIdentity& identity, bool fresh, const Carry& carry = {},
      const TableInfo& info = {}, const Visit& visit = [](const JournalledRow&) {});
  /// Syncs if possible, without an error if not, and releases the lock.
  ~Journal();
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;

  /// Whether the file system has no locks, so that a file of another kind keeps other runs away.
  bool is_locked_by_file() const;
  /// Whether there is a journal of rank 0. An empty one belongs to a run that was begun.
  bool is_there() const;
  /// Makes a journal of `count` rows, or appends them to the journal that is there. Throws OutputError, IoError.
  using RowOf = JournalFile::RowOf;
  void begin(std::uint64_t count, const RowOf& row);

  /// The rows that are in the journals, each index once, in order of index. They are read again.
  std::vector<JournalledRow> recovered() const;
  /// Number of records that were found damaged or torn when it was opened. Their rows must be computed again.
  std::uint64_t dropped() const;
  /// Journals that were passed over, and why.
  const std::vector<std::string>& passed_over() const;

  /// The journal of rank 0, to append to; it is made if it is not there. Throws OutputError.
  JournalFile& file();
  void append(std::span<const Row> rows) { file().append(rows); }
  void append(const Row& row) { append({&row, 1}); }
  /// As JournalFile::sync().
  void sync();
  /// Removes the journals of all ranks, once the table is complete and checked. Nothing can be appended afterwards; the
  /// lock stays. That of rank 0 goes first: without it the others say nothing where a complete table is.
  void remove();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sigmasweep
