#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// System calls on files, with retries and an owner of the descriptor.
namespace sigmasweep {

/// Owner of a file descriptor; closed with it, and never inherited by another program.
class File {
 public:
  File() = default;
  /// Takes over a descriptor that is open.
  explicit File(int fd) : fd_(fd) {}
  /// open(2). On failure is_open() is false and errno says why.
  File(const std::string& path, int flags);
  ~File() { close(); }
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }
  void close();

 private:
  int fd_ = -1;
};

/// The meaning of a value of errno, in words.
std::string reason(int error);

/// Writes all of `bytes` at `offset`. Returns 0, or the errno of a failure; some bytes may then have been written.
int write_at(int fd, std::span<const std::byte> bytes, std::uint64_t offset);

/// Writes all of `bytes` where the descriptor stands, a stream's end. Returns 0, or the errno of a failure.
int write_all(int fd, std::span<const std::byte> bytes);

/// Reads up to bytes.size() bytes at `offset`, fewer only at the end of the file. Throws IoError naming `path`.
std::size_t read_at(int fd, std::span<std::byte> bytes, std::uint64_t offset, const std::string& path);

/// Whether the file of this name is the one that the descriptor has open: another process may have removed or replaced
/// it. A symbolic link is not followed.
bool is_name_of(const std::string& path, int fd);

/// Makes creation, renaming or removal of `path` itself survive a power failure. Throws IoError.
void sync_directory_of(const std::string& path);

}  // namespace sigmasweep
