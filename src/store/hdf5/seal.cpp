#include "store/hdf5/seal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

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

/// The seal of a file of this size, if it has one.
std::optional<Seal> seal_of(const File& file, std::uint64_t size, const std::string& path) {
  Seal found{};
  if (size < sizeof found) return std::nullopt;
  read_at(file.fd(), std::as_writable_bytes(std::span(&found, 1)), size - sizeof found, path);
  if (found.magic != Seal{}.magic) return std::nullopt;
  return found;
}

/// Bytes of the superblock that HDF5 changes when it opens a file for writing (HDF5 File Format Specification, II.A):
/// in versions 0 and 1 the consistency flags; from version 2 on the flags, and the checksum behind the four addresses.
struct Range {
  std::size_t first = 0, size = 0;
};
std::array<Range, 2> unsealed_ranges(std::span<const std::byte> head) {
  constexpr std::size_t version_at = 8;
  if (head.size() <= version_at) return {};
  if (std::to_integer<int>(head[version_at]) < 2) return {{{20, 4}, {}}};
  return {{{11, 1}, {44, 4}}};
}

/// Sets what is not sealed to 0. `head`: the first bytes of the file.
void clear_notes(std::span<std::byte> head) {
  for (const auto [first, size] : unsealed_ranges(head))
    if (first + size <= head.size()) std::ranges::fill(head.subspan(first, size), std::byte{0});
}

class Xxh3 {
 public:
  Xxh3() : state_(XXH3_createState(), XXH3_freeState) {
    if (!state_ || XXH3_64bits_reset(state_.get()) != XXH_OK) throw std::bad_alloc();
  }
  void add(std::span<const std::byte> bytes) { XXH3_64bits_update(state_.get(), bytes.data(), bytes.size()); }
  std::uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

 private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

std::uint64_t checksum_of(const File& file, std::uint64_t size, const std::string& path) {
  Xxh3 sum;
  std::vector<std::byte> buffer(std::min<std::uint64_t>(size, std::uint64_t{1} << 20));
  for (std::uint64_t done = 0; done < size;) {
    const auto bytes = std::span(buffer).first(std::min<std::uint64_t>(size - done, buffer.size()));
    if (read_at(file.fd(), bytes, done, path) != bytes.size())
      throw IoError(fmt::format("cannot read {}: it ends early", path));
    if (done == 0) clear_notes(bytes);
    sum.add(bytes);
    done += bytes.size();
  }
  return sum.value();
}

}  // namespace

void seal(const std::string& path) {
  const File file(path, O_RDWR | O_NOFOLLOW);
  if (!file.is_open()) throw IoError(fmt::format("cannot open {}: {}", path, reason(errno)));
  const std::uint64_t size = size_of(file, path);
  const Seal seal{.checksum = checksum_of(file, size, path)};
  const int error = write_at(file.fd(), std::as_bytes(std::span(&seal, 1)), size);
  if (error != 0) throw IoError(fmt::format("cannot write {}: {}", path, reason(error)));
  if (::fsync(file.fd()) != 0) throw IoError(fmt::format("cannot sync: {}", reason(errno)));
}

void seal(std::vector<std::byte>& image) {
  std::vector<std::byte> head(image.begin(), image.begin() + std::min<std::ptrdiff_t>(std::ssize(image), 64));
  clear_notes(head);
  Xxh3 sum;
  sum.add(head);
  sum.add(std::span(image).subspan(head.size()));
  const Seal seal{.checksum = sum.value()};
  const auto bytes = std::as_bytes(std::span(&seal, 1));
  image.insert(image.end(), bytes.begin(), bytes.end());
}

bool has_seal(const File& file) { return seal_of(file, size_of(file, "the file"), "the file").has_value(); }

void check_seal(const File& file, const std::string& path) {
  const std::uint64_t size = size_of(file, path);
  const auto found = seal_of(file, size, path);
  if (!found || found->checksum == checksum_of(file, size - sizeof(Seal), path)) return;
  throw IoError("it was damaged or changed after it was written");
}

bool is_noted_as_open(const File& file, const std::string& path) {
  std::array<std::byte, 64> head{};
  const std::size_t got = read_at(file.fd(), head, 0, path);
  const auto [first, size] = unsealed_ranges(std::span(head).first(got))[0];
  return std::ranges::any_of(std::span(head).subspan(first, size), [](std::byte b) { return b != std::byte{0}; });
}

}  // namespace sigmasweep
