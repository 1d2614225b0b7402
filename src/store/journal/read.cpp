#include "store/journal/read.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <span>
#include <utility>

#include "base/file.hpp"
#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "store/journal/description.hpp"
#include "store/journal/recover.hpp"

namespace sigmasweep {

std::optional<JournalledRows> read_journal(const std::string& table_path) {
  const std::string path = beside(table_path, ".journal");
  const File file(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW);  // a FIFO of that name must not hold us up
  if (!file.is_open() && (errno == ENOENT || errno == ENOTDIR)) return std::nullopt;
  if (!file.is_open()) throw IoError(fmt::format("cannot open {}: {}", path, reason(errno)));
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0) throw IoError(fmt::format("cannot read {}: {}", path, reason(errno)));
  JournalHeader header;
  std::size_t size = 0;
  if (S_ISREG(status.st_mode)) size = read_at(file.fd(), std::as_writable_bytes(std::span(&header, 1)), 0, path);
  if (const std::string why = why_unreadable(header, size); !why.empty())
    throw IoError(fmt::format("{} {}", path, why));
  if (header.physics_version != physics_version)
    throw IoError(fmt::format("{} was begun with physics version {}, this program has {}", path, header.physics_version,
                              physics_version));
  const auto text = read_description(file, path, header);
  auto info = text ? parse_description(*text) : std::nullopt;
  if (!info)
    throw IoError(fmt::format("{} is damaged where it describes the sweep; 'sigmasweep run' goes on with it", path));
  JournalledRows found;
  found.total = info->slice.size(header.rows);
  found.info = std::move(*info);
  found.rows = recover_rows(file, path, header);
  return found;
}

}  // namespace sigmasweep
