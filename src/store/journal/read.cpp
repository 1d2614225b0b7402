#include "store/journal/read.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <utility>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "store/journal/names.hpp"
#include "store/journal/open.hpp"
#include "store/journal/recover.hpp"

namespace sigmasweep {
namespace {

bool is_gone(const OpenJournal& journal) {
  return !journal.is_there() && (journal.error == ENOENT || journal.error == ENOTDIR);
}

/// Why a journal cannot be the one that tells what the sweep is; empty if it can.
std::string why_not_readable(const OpenJournal& journal) {
  if (!journal.is_there()) return fmt::format("cannot open {}: {}", journal.path, reason(journal.error));
  if (const std::string why = why_unreadable(journal.header, journal.header_size); !why.empty())
    return fmt::format("{} {}", journal.path, why);
  if (journal.header.physics_version != physics_version)
    return fmt::format("{} was begun with physics version {}, this program has {}", journal.path,
                       journal.header.physics_version, physics_version);
  if (!journal.description)
    return fmt::format("{} is damaged where it describes the sweep; 'sigmasweep run' goes on with it", journal.path);
  if (const std::string why = journal.why_unreadable(); !why.empty()) return fmt::format("{} {}", journal.path, why);
  return {};
}

void add_rows(const OpenJournal& journal, std::span<const Field> results, std::vector<JournalledRow>& rows) {
  const auto fields = journal.fields(results);
  if (!fields) return;
  RecordReader reader(journal.file, journal.path, journal.header, *fields);
  reader.read_all([&](const JournalledRow& row) { rows.push_back(row); });
}

}  // namespace

std::optional<JournalledRows> read_journal(const std::string& table_path) {
  std::optional<OpenJournal> first;
  std::string why_not;
  JournalledRows found;
  for (const std::string& path : journals_beside(table_path)) {
    OpenJournal journal = open_journal(path, O_RDONLY);
    if (is_gone(journal)) continue;
    if (!first) {
      if (std::string why = why_not_readable(journal); !why.empty()) {
        if (why_not.empty()) why_not = std::move(why);
        continue;
      }
      found.has_first = path == journal_of_rank(table_path, 0);
      found.info = journal.description->info;
      found.total = found.info.slice.size(journal.header.rows);
      first = std::move(journal);
      add_rows(*first, {}, found.rows);
    } else if (is_of_same_sweep(journal.header, first->header)) {
      add_rows(journal, first->description->results, found.rows);
    }
  }
  if (!first && !why_not.empty()) throw IoError(why_not);
  if (!first) return std::nullopt;
  keep_one_of_each_index(found.rows);
  return found;
}

}  // namespace sigmasweep
