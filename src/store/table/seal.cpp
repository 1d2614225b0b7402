#include "store/table/seal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "base/file.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

struct Seal {
  std::uint64_t magic = 0x0a4c414553575353;  // "SSWSEAL\n" on a little-endian machine
  std::uint64_t checksum = 0;
};

std::uint64_t size_of(const File& file, const std::string& path) {
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0) throw IoError(fmt::format("cannot read {}: {}", path, reason(errno)));
  return S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
}

std::uint64_t checksum_of(const File& file, std::uint64_t size, const std::string& path) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
  if (!state || XXH3_64bits_reset(state.get()) != XXH_OK) throw std::bad_alloc();
  std::vector<std::byte> buffer(std::min<std::uint64_t>(size, std::uint64_t{1} << 20));
  for (std::uint64_t done = 0; done < size;) {
    const auto bytes = std::span(buffer).first(std::min<std::uint64_t>(size - done, buffer.size()));
    if (read_at(file.fd(), bytes, done, path) != bytes.size() ||
        XXH3_64bits_update(state.get(), bytes.data(), bytes.size()) != XXH_OK)
      throw IoError(fmt::format("cannot read {}: it ends early", path));
    done += bytes.size();
  }
  return XXH3_64bits_digest(state.get());
}

}  // namespace

void seal(const std::string& path) {
  const File file(path, O_RDWR);
  if (!file.is_open()) throw IoError(fmt::format("cannot open {}: {}", path, reason(errno)));
  const std::uint64_t size = size_of(file, path);
  const Seal seal{.checksum = checksum_of(file, size, path)};
  const int error = write_at(file.fd(), std::as_bytes(std::span(&seal, 1)), size);
  if (error != 0) throw IoError(fmt::format("cannot write {}: {}", path, reason(error)));
  if (::fsync(file.fd()) != 0) throw IoError(fmt::format("cannot sync: {}", reason(errno)));
}

void check_seal(const std::string& path) {
  const File file(path, O_RDONLY);
  if (!file.is_open()) throw IoError(fmt::format("cannot open: {}", reason(errno)));
  const std::uint64_t size = size_of(file, path);
  if (size < sizeof(Seal)) return;
  Seal found{};
  const std::uint64_t sealed = size - sizeof found;
  read_at(file.fd(), std::as_writable_bytes(std::span(&found, 1)), sealed, path);
  if (found.magic == Seal{}.magic && found.checksum != checksum_of(file, sealed, path))
    throw IoError("it was damaged after it was written");
}

}  // namespace sigmasweep
