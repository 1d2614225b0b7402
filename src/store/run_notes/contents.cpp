#include "store/run_notes/contents.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <bit>
#include <cstring>
#include <span>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::notes {
namespace {

constexpr std::uint64_t max_suspected = 1 << 24;

bool is_sound(const Header& header, std::uint64_t size) {
  if (header.is_magic != magic || header.ranks > max_ranks || header.suspected > max_suspected) return false;
  if (header.page_size < min_page_size || header.page_size > max_page_size || !std::has_single_bit(header.page_size))
    return false;
  return size == header.page_size * (1 + header.ranks) + header.suspected * sizeof(Suspicion);
}

}  // namespace

std::string path_of(const std::string& table) { return beside(table, ".running"); }

std::optional<Contents> read(const std::string& path) {
  const File file(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW);  // a FIFO of that name must not hold us up
  struct stat status {};
  if (!file.is_open() || ::fstat(file.fd(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  const auto fill = [&](auto& items, std::uint64_t offset) {
    const auto bytes = std::as_writable_bytes(std::span(items));
    return read_at(file.fd(), bytes, offset, path) == bytes.size();
  };
  Contents found;
  std::span header(&found.header, 1);
  if (!fill(header, 0) || !is_sound(found.header, static_cast<std::uint64_t>(status.st_size))) return std::nullopt;
  std::uint64_t offset = found.header.page_size;
  found.ranks.resize(found.header.ranks);
  for (RankPage& rank : found.ranks) {
    std::span page(&rank, 1);
    if (!fill(page, offset)) return std::nullopt;
    rank.host.back() = '\0';
    offset += found.header.page_size;
  }
  found.suspicions.resize(found.header.suspected);
  if (!fill(found.suspicions, offset)) return std::nullopt;
  return found;
}

void write(const std::string& path, const Contents& contents) {
  const Header& header = contents.header;
  const std::span suspicions(contents.suspicions);
  std::vector<std::byte> bytes(header.page_size * (1 + header.ranks) + suspicions.size_bytes());
  std::memcpy(bytes.data(), &header, sizeof header);
  if (!suspicions.empty())
    std::memcpy(bytes.data() + bytes.size() - suspicions.size_bytes(), suspicions.data(), suspicions.size_bytes());
  require_plain(path);
  AtomicFile file(path);
  int error = write_at(file.fd(), bytes, 0);
  if (error == 0) error = file.rename();
  if (error != 0) throw OutputError(fmt::format("cannot create {}: {}", path, reason(error)));
}

}  // namespace sigmasweep::notes
