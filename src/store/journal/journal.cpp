#include "store/journal/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <utility>

#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "store/journal/lock.hpp"
#include "store/journal/names.hpp"
#include "store/journal/open.hpp"

namespace sigmasweep {
namespace {

/// Removes a journal of another rank, whatever it holds; a thing of another kind that has its name stays.
void remove_journal(const std::string& path) {
  require_plain(path);
  if (::unlink(path.c_str()) != 0 && errno != ENOENT)
    throw OutputError(fmt::format("cannot remove {}: {}", path, reason(errno)));
}

}  // namespace

struct Journal::Impl {
  Impl(std::string table_path, const JournalIdentity& identity_, const TableInfo& info)
      : lock(table_path),
        table(std::move(table_path)),
        identity(identity_),
        own(journal_of_rank(table, 0), identity, info) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() = default;

  void begin_fresh();
  void remove_others() const;
  void open_existing(const Carry& carry, const Visit& visit);
  void open_without_own(const Visit& visit);
  void go_on(OpenJournal found, const Visit& visit);
  std::string why_unusable(const OpenJournal& found) const;
  bool is_same_but_for_the_sweep(const OpenJournal& found) const;
  [[noreturn]] void refuse(const OpenJournal& found, const std::string& why) const;
  bool replace(const OpenJournal& old, const Carry& carry, const Visit& visit);
  bool visit_others(const Visit& visit);
  void visit_all(const OpenJournal& journal, const Visit& visit);
  std::vector<JournalledRow> rows_of_set(const OpenJournal& first) const;

  TableLock lock;  // first in, last out
  std::string table;
  JournalIdentity identity;
  JournalFile own;
  std::uint64_t dropped = 0;
  std::vector<std::string> passed_over;
};

void Journal::Impl::remove_others() const {
  for (const int rank : other_ranks_with_journals(table)) remove_journal(journal_of_rank(table, rank));
}

void Journal::Impl::begin_fresh() {
  remove_others();
  own.create(0, JournalFile::RowOf());
}

std::string Journal::Impl::why_unusable(const OpenJournal& found) const {
  if (std::string why = sigmasweep::why_unusable(found.header, found.header_size, identity); !why.empty()) return why;
  return found.why_unreadable(identity.results);
}

bool Journal::Impl::is_same_but_for_the_sweep(const OpenJournal& found) const {
  const JournalIdentity theirs{found.header.spec_hash, identity.physics_version, found.header.rows};
  return sigmasweep::why_unusable(found.header, found.header_size, theirs).empty() &&
         found.why_unreadable(identity.results).empty();
}

void Journal::Impl::refuse(const OpenJournal& found, const std::string& why) const {
  throw OutputError(fmt::format(
      "{} {}. {}tart the sweep again with --fresh, which replaces it, or choose another "
      "output with -o",
      found.path, why,
      is_same_but_for_the_sweep(found) ? "Go on with --extend, which keeps the rows that are the same, s" : "S"));
}

void Journal::Impl::visit_all(const OpenJournal& journal, const Visit& visit) {
  RecordReader reader(journal.file, journal.path, journal.header, journal.fields(identity.results).value());
  reader.read_all(visit);
  dropped += reader.dropped();
}

/// Hands on the rows of the other ranks' journals. Returns whether there is one of this sweep.
bool Journal::Impl::visit_others(const Visit& visit) {
  bool is_some = false;
  for (const int rank : other_ranks_with_journals(table)) {
    const OpenJournal found = open_journal(journal_of_rank(table, rank), O_RDONLY);
    if (const std::string why = why_unusable(found); !why.empty()) {
      passed_over.push_back(fmt::format("{} {}", found.path, why));
      continue;
    }
    is_some = true;
    visit_all(found, visit);
  }
  return is_some;
}

void Journal::Impl::open_existing(const Carry& carry, const Visit& visit) {
  OpenJournal found = open_journal(own.path(), O_RDWR);
  if (!found.is_there() && found.error == ENOENT) return open_without_own(visit);
  if (!found.is_there() && found.error == ELOOP) require_plain(own.path());
  if (!found.is_there()) throw OutputError(fmt::format("cannot open {}: {}", own.path(), reason(found.error)));
  const std::string why = why_unusable(found);
  if (why.empty()) return go_on(std::move(found), visit);
  if (carry && is_same_but_for_the_sweep(found) && replace(found, carry, visit)) return;
  const bool is_damaged = found.is_ours() && !sigmasweep::why_unreadable(found.header, found.header_size).empty();
  if (!is_damaged || !visit_others(visit)) refuse(found, why);
  passed_over.push_back(fmt::format("{} {}", own.path(), why));
  own.create(0, JournalFile::RowOf());
}

/// Journals of other ranks count without that of rank 0, too. Where they are of something else, a table tells that they
/// are left from a run that has ended; otherwise they are all that is left of it.
void Journal::Impl::open_without_own(const Visit& visit) {
  const std::vector<int> others = other_ranks_with_journals(table);
  if (visit_others(visit) || others.empty() || std::filesystem::exists(table)) return;
  const OpenJournal found = open_journal(journal_of_rank(table, others.front()), O_RDONLY);
  refuse(found, why_unusable(found));
}

void Journal::Impl::go_on(OpenJournal found, const Visit& visit) {
  const bool is_as_written_now = found.header.format_version == journal_format_version && found.description;
  RecordReader reader(found.file, found.path, found.header, found.fields(identity.results).value());
  std::vector<JournalledRow> rows;
  const auto take = [&](const JournalledRow& row) {
    visit(row);
    if (!is_as_written_now) rows.push_back(row);
  };
  reader.read_all(take);
  dropped += reader.dropped();
  if (is_as_written_now)
    own.go_on(std::move(found.file), found.header, reader.records());
  else
    own.create(rows);
  visit_others(visit);
}

/// The rows of all journals that are of the sweep of the first one.
std::vector<JournalledRow> Journal::Impl::rows_of_set(const OpenJournal& first) const {
  std::vector<JournalledRow> rows;
  const auto results = first.description ? std::span<const Field>(first.description->results) : identity.results;
  for (const std::string& path : journals_beside(table)) {
    const OpenJournal journal = open_journal(path, O_RDONLY);
    if (!journal.is_there() || !is_of_same_sweep(journal.header, first.header)) continue;
    const auto fields = journal.fields(results);
    if (!fields) continue;
    RecordReader reader(journal.file, path, journal.header, *fields);
    reader.read_all([&](const JournalledRow& row) { rows.push_back(row); });
  }
  keep_one_of_each_index(rows);
  return rows;
}

/// Returns false, and leaves everything as it was, where carry() refuses.
bool Journal::Impl::replace(const OpenJournal& old, const Carry& carry, const Visit& visit) {
  const auto info = old.description ? std::optional(old.description->info) : std::nullopt;
  const auto taken = carry(rows_of_set(old), info);
  if (!taken) return false;
  own.create(taken->size(), [&](std::uint64_t k) { return (*taken)[k]; });
  remove_others();
  for (const Row& row : *taken) visit({row, content_key(row.parameters)});
  return true;
}

Journal::Journal(const std::string& table_path, const JournalIdentity& identity, bool fresh, const Carry& carry,
                 const TableInfo& info, const Visit& visit)
    : impl_(std::make_unique<Impl>(table_path, identity, info)) {
  if (fresh)
    impl_->begin_fresh();
  else
    impl_->open_existing(carry, visit);
}

Journal::~Journal() = default;
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;

bool Journal::is_locked_by_file() const { return impl_->lock.is_by_owner_file(); }
bool Journal::is_there() const { return impl_->own.is_there(); }
std::uint64_t Journal::dropped() const { return impl_->dropped; }
const std::vector<std::string>& Journal::passed_over() const { return impl_->passed_over; }

void Journal::begin(std::uint64_t count, const RowOf& row) {
  if (!is_there()) return impl_->own.create(count, row);
  for (std::uint64_t k = 0; k < count; ++k) append(row(k));
}

std::vector<JournalledRow> Journal::recovered() const {
  if (!is_there()) return {};
  return impl_->rows_of_set(open_journal(impl_->own.path(), O_RDONLY));
}

JournalFile& Journal::file() {
  impl_->own.check();
  if (!is_there()) impl_->own.create(0, RowOf());
  return impl_->own;
}

void Journal::sync() { impl_->own.sync(); }

void Journal::remove() {
  impl_->own.remove();
  for (const int rank : other_ranks_with_journals(impl_->table))
    if (const std::string path = journal_of_rank(impl_->table, rank); open_journal(path, O_RDONLY).is_ours())
      remove_journal(path);
  sync_directory_of(impl_->own.path());
}

}  // namespace sigmasweep
