#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/file.hpp"

namespace sigmasweep {

/// A new file PATH that is complete or not there: it is written as PATH.part and takes its name at the end. An older
/// file PATH stays as it was until then. If it is not published, PATH.part is removed.
///
/// A symbolic link PATH stands for its target (output/place.hpp). Where PATH is a stream, the bytes are kept in memory
/// and go to the stream at the end.
class AtomicFile {
 public:
  /// Creates PATH.part, empty. A file of that name that an interrupted run left is removed first. Throws OutputError,
  /// also where anything else has that name: it is never followed, opened or removed.
  explicit AtomicFile(const std::string& path, const std::string& suffix = ".part");
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The file's name for now; empty for a stream.
  const std::string& part() const { return part_; }
  int fd() const { return file_.fd(); }
  /// Closes the descriptor, for a file that others write.
  void close() { file_.close(); }
  /// Brings the bytes to the disk. Returns 0, or the errno of a failure.
  int sync() const;
  /// Renames PATH.part to PATH, or writes the stream. Returns 0, or the errno of a failure.
  int rename();
  /// The same; throws OutputError.
  void publish();
  /// The open file, which outlives this object.
  File release() { return std::move(file_); }

 private:
  std::string path_, part_;
  std::optional<File> stream_;
  File file_;
  bool published_ = false;
};

/// Makes PATH a file of these bytes that survives a power failure: written to PATH.part, synced, renamed. PATH is
/// complete or as it was before. Throws OutputError (cannot be created) or IoError (full disk, failed write).
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

/// Makes PATH a file of this text, which is not synced. PATH is complete or as it was before. Throws OutputError
/// (cannot be created) or IoError (full disk, failed write).
void write_text_file(const std::string& path, std::string_view text, const std::string& suffix = ".part");

}  // namespace sigmasweep
