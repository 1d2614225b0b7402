#include "store/journal/open.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

OpenJournal open_journal(const std::string& path, int flags) {
  OpenJournal journal{.path = path};
  journal.file = File(path, flags | O_NOFOLLOW | O_NONBLOCK);
  if (!journal.is_there()) {
    journal.error = errno;
    return journal;
  }
  struct stat status {};
  if (::fstat(journal.file.fd(), &status) != 0) throw IoError(fmt::format("cannot read {}: {}", path, reason(errno)));
  if (!S_ISREG(status.st_mode)) return journal;
  journal.header_size = read_at(journal.file.fd(), std::as_writable_bytes(std::span(&journal.header, 1)), 0, path);
  if (!sigmasweep::why_unreadable(journal.header, journal.header_size).empty()) return journal;
  if (const auto text = read_description(journal.file, path, journal.header))
    journal.description = parse_description(*text);
  return journal;
}

std::string OpenJournal::why_unreadable(std::span<const Field> results) const {
  if (std::string why = sigmasweep::why_unreadable(header, header_size); !why.empty()) return why;
  if (!fields(results)) return other_fields;
  return {};
}

std::optional<std::vector<Field>> OpenJournal::fields(std::span<const Field> results) const {
  return record_fields(header, description ? std::span<const Field>(description->results) : results);
}

}  // namespace sigmasweep
