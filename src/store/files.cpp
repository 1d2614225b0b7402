#include "store/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

File::File(const std::string& path, int flags) {
  do {
    fd_ = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  } while (fd_ < 0 && errno == EINTR);
}

File::File(File&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

void File::close() {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

std::string reason(int error) { return std::generic_category().message(error); }

int write_at(int fd, std::span<const std::byte> bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(fd, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return 0;
}

std::size_t read_at(int fd, std::span<std::byte> bytes, std::uint64_t offset, const std::string& path) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(fd, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw IoError(fmt::format("cannot read {}: {}", path, reason(errno)));
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string part = path + ".part";
  const File file(part, O_WRONLY | O_CREAT | O_TRUNC);
  if (!file.is_open()) throw OutputError(fmt::format("cannot create {}: {}", part, reason(errno)));
  int error = write_at(file.fd(), bytes, 0);
  if (error == 0 && ::fsync(file.fd()) != 0) error = errno;
  const bool written = error == 0;
  if (written && std::rename(part.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return sync_directory_of(path);
  ::unlink(part.c_str());
  if (written) throw OutputError(fmt::format("cannot create {}: {}", path, reason(error)));
  throw IoError(fmt::format("cannot write {}: {}", part, reason(error)));
}

void sync_directory_of(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  const std::string directory = parent.empty() ? std::string(".") : parent;
  const File opened(directory, O_RDONLY | O_DIRECTORY);
  // EINVAL: a file system that does not sync directories, as it does not need to.
  if (!opened.is_open() || (::fsync(opened.fd()) != 0 && errno != EINVAL))
    throw IoError(fmt::format("cannot sync directory {}: {}", directory, reason(errno)));
}

}  // namespace sigmasweep
