#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/journal/background_sync.hpp"
#include "store/journal/description.hpp"
#include "store/journal/record.hpp"

namespace sigmasweep {

/// A journal that this process writes: an append-only file of records. It is the only writer of the file.
class JournalFile {
 public:
  JournalFile(std::string path, const JournalIdentity& identity, const TableInfo& info);
  /// Syncs if possible, without an error if not.
  ~JournalFile() = default;
  JournalFile(JournalFile&&) noexcept = default;
  JournalFile& operator=(JournalFile&&) = delete;

  const std::string& path() const { return path_; }
  /// Whether there is a file.
  bool is_there() const { return file_.is_open(); }

  /// Makes a journal that begins with these rows, in place of whatever is there. It appears complete: a journal always
  /// has a whole header. Throws OutputError.
  using RowOf = std::function<Row(std::uint64_t k)>;
  void create(std::uint64_t count, const RowOf& row);
  /// The same with rows of another journal.
  void create(std::span<const JournalledRow> rows);
  /// Goes on with a journal of format 3 that has so many records; what follows them is cut off. Throws IoError.
  void go_on(File file, const JournalHeader& header, std::uint64_t records);
  /// Goes on with the journal of the same sweep that is there, or makes one; a journal of another sweep is replaced. It
  /// is locked, because a rank of a run that died may still be about to write to it. Throws OutputError where a file of
  /// another kind has the name, or where the lock is not free after some seconds; IoError.
  void begin_alone();

  /// Writes the records at once, in one write, so that a killed process loses nothing. A thread brings them to the disk
  /// about a second later, so that a machine that loses its power loses the rows of the last second or two. Throws
  /// IoError naming the file and the cause (disk full); the journal then ends with its last whole record and can be
  /// continued. After a failed sync it stays failed: the content of the disk is unknown until the journal is opened
  /// again.
  void append(std::span<const Row> rows);
  /// Brings all appended rows to the disk. Throws IoError.
  void sync();
  /// Throws IoError if nothing can be appended any more: a sync failed meanwhile.
  void check() const;
  /// Removes the file. Nothing can be appended afterwards.
  void remove();

 private:
  std::uint64_t end() const { return first_record(header_) + records_ * codec_.size(); }
  using Encode = std::function<void(std::uint64_t k)>;
  void make(std::uint64_t count, const Encode& encode);
  void encode(const Row& row, std::uint64_t content_key);
  int write(int fd);
  void cut_behind_last_whole_record();
  [[noreturn]] void fail(const char* what, int error) const;

  std::string path_, description_;
  std::vector<Field> results_;
  std::uint64_t rows_;
  JournalHeader header_;  // of the file, once there is one
  RecordCodec codec_;
  File file_;
  std::unique_ptr<BackgroundSync> syncing_;  // of the file, once something is written
  std::vector<std::byte> buffer_;            // the records of the next write
  std::uint64_t records_ = 0;                // in the file, damaged ones included
  std::string failure_;                      // why nothing can be written any more
};

}  // namespace sigmasweep
