#pragma once

#include <string>
#include <thread>

#include "base/file.hpp"

namespace sigmasweep {

/// A lock for file systems that have none: a file that only one process can make, and that says which one it was. The
/// file is touched every 20 s while the process lives. A file whose process is dead is replaced: of this machine the
/// processes are known, of other machines the file has not been touched for two minutes then.
class OwnerFile {
 public:
  /// Throws OutputError: `table_path` is in use by another process, or the file cannot be made.
  OwnerFile(std::string path, const std::string& table_path);
  ~OwnerFile();
  OwnerFile(const OwnerFile&) = delete;
  OwnerFile& operator=(const OwnerFile&) = delete;

 private:
  void keep_beating(const std::stop_token& stop) const;
  std::string path_;
  File file_;
  std::jthread heart_;  // last: it uses the file
};

}  // namespace sigmasweep
