#pragma once

#include <memory>
#include <string>

#include "base/file.hpp"
#include "store/journal/owner_file.hpp"

namespace sigmasweep {

/// Takes an exclusive lock on an open file, which lasts until this process closes any descriptor of that file. True as
/// well where the file system has no locks; false while another process has it, or if that is not known.
bool lock_whole_file(const File& file);

/// The right to write TABLE.h5 and its journals: an exclusive fcntl lock on TABLE.h5.lock, held for the lifetime of the
/// object. The system releases it when the process dies, however that happens. It excludes other processes, not other
/// objects of the same process. On a file system without locks TABLE.h5.owner takes its place (owner_file.hpp).
class TableLock {
 public:
  /// Throws OutputError: held by another process (named by its id), or the lock file cannot be made.
  explicit TableLock(const std::string& table_path);
  ~TableLock();
  TableLock(const TableLock&) = delete;
  TableLock& operator=(const TableLock&) = delete;
  bool is_by_owner_file() const { return owner_ != nullptr; }

 private:
  void remove();
  std::string path_;
  File file_;
  std::unique_ptr<OwnerFile> owner_;
};

}  // namespace sigmasweep
