#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

AtomicFile::AtomicFile(const std::string& path, const std::string& suffix)
    : path_(path), part_(path + suffix), file_(part_, O_RDWR | O_CREAT | O_TRUNC) {
  if (!file_.is_open()) throw OutputError(fmt::format("cannot create {}: {}", path_, reason(errno)));
}

AtomicFile::~AtomicFile() {
  if (!published_) ::unlink(part_.c_str());
}

int AtomicFile::sync() const { return ::fsync(file_.fd()) == 0 ? 0 : errno; }

int AtomicFile::rename() {
  if (std::rename(part_.c_str(), path_.c_str()) != 0) return errno;
  published_ = true;
  return 0;
}

void AtomicFile::publish() {
  if (const int error = rename(); error != 0)
    throw OutputError(fmt::format("cannot create {}: {}", path_, reason(error)));
}

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  AtomicFile file(path);
  int error = write_at(file.fd(), bytes, 0);
  if (error == 0) error = file.sync();
  if (error != 0) throw IoError(fmt::format("cannot write {}: {}", file.part(), reason(error)));
  file.publish();
  sync_directory_of(path);
}

}  // namespace sigmasweep
