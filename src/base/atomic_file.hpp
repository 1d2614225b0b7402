#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "base/file.hpp"

namespace sigmasweep {

/// A new file PATH that is complete or not there: it is written as PATH.part and takes its name at the end. An older
/// file PATH stays as it was until then. If it is not published, PATH.part is removed.
class AtomicFile {
 public:
  /// Creates PATH.part, empty. Throws OutputError.
  explicit AtomicFile(const std::string& path, const std::string& suffix = ".part");
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::string& part() const { return part_; }
  int fd() const { return file_.fd(); }
  /// Closes the descriptor, for a file that others write.
  void close() { file_.close(); }
  /// Brings the bytes to the disk. Returns 0, or the errno of a failure.
  int sync() const;
  /// Renames PATH.part to PATH. Returns 0, or the errno of a failure.
  int rename();
  /// The same; throws OutputError.
  void publish();
  /// The open file, which outlives this object.
  File release() { return std::move(file_); }

 private:
  std::string path_, part_;
  File file_;
  bool published_ = false;
};

/// Makes PATH a file of these bytes that survives a power failure: written to PATH.part, synced, renamed. PATH is
/// complete or as it was before. Throws OutputError (cannot be created) or IoError (full disk, failed write).
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace sigmasweep
