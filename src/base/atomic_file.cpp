#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <vector>

#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

/// Whether a file may be one that this program left: a plain file of this user with one name.
bool is_leftover(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 1 &&
         status.st_uid == ::geteuid();
}

/// Creates a file that was not there, or only as a leftover. On failure it is not open and errno says why.
File create_new(const std::string& path) {
  constexpr int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW;
  File file(path, flags);
  if (file.is_open() || errno != EEXIST) return file;
  if (!is_leftover(path))
    throw OutputError(fmt::format("cannot create {}: what has this name is not of an earlier run, remove it", path));
  ::unlink(path.c_str());
  return File(path, flags);
}

/// Writes all of a file to a stream. Returns 0, or the errno of a failure.
int copy(int from, int to) {
  std::vector<std::byte> buffer(std::size_t{1} << 16);
  for (std::uint64_t offset = 0;;) {
    const std::size_t got = read_at(from, buffer, offset, "a file in memory");
    if (got == 0) return 0;
    if (const int error = write_all(to, std::span(buffer).first(got)); error != 0) return error;
    offset += got;
  }
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path, const std::string& suffix) : path_(path), stream_(open_stream(path)) {
  if (stream_) {
    file_ = File(::memfd_create("output", MFD_CLOEXEC));
  } else {
    path_ = linked_file(path);
    part_ = path_ + suffix;
    file_ = create_new(part_);
  }
  if (!file_.is_open()) throw OutputError(fmt::format("cannot create {}: {}", path_, reason(errno)));
}

AtomicFile::~AtomicFile() {
  if (published_ || stream_) return;
  if (!file_.is_open() || is_name_of(part_, file_.fd())) ::unlink(part_.c_str());
}

int AtomicFile::sync() const { return stream_ || ::fsync(file_.fd()) == 0 ? 0 : errno; }

int AtomicFile::rename() {
  if (stream_) return copy(file_.fd(), stream_->fd());
  if (file_.is_open() && !is_name_of(part_, file_.fd())) return EBUSY;  // another process writes PATH, too
  if (std::rename(part_.c_str(), path_.c_str()) != 0) return errno;
  published_ = true;
  return 0;
}

void AtomicFile::publish() {
  if (const int error = rename(); error != 0)
    throw OutputError(fmt::format("cannot create {}: {}", path_, reason(error)));
}

void write_text_file(const std::string& path, std::string_view text, const std::string& suffix) {
  AtomicFile file(path, suffix);
  if (const int error = write_all(file.fd(), std::as_bytes(std::span(text))); error != 0)
    throw IoError(fmt::format("cannot write {}: {}", path, reason(error)));
  file.publish();
}

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  AtomicFile file(path);
  int error = write_at(file.fd(), bytes, 0);
  if (error == 0) error = file.sync();
  if (error != 0)
    throw IoError(fmt::format("cannot write {}: {}", file.part().empty() ? path : file.part(), reason(error)));
  file.publish();
  if (!file.part().empty()) sync_directory_of(file.part());
}

}  // namespace sigmasweep
