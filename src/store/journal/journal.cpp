#include "store/journal/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <span>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/journal/background_sync.hpp"
#include "store/journal/description.hpp"
#include "store/journal/lock.hpp"
#include "store/journal/record.hpp"
#include "store/journal/recover.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t rows_at_a_time = 4096;  // of a journal that is made

}  // namespace

struct Journal::Impl {
  Impl(const std::string& table_path, const JournalIdentity& identity_, bool fresh, const Carry& carry,
       const TableInfo& info, const Visit& visit)
      : lock(table_path),
        path(beside(table_path, ".journal")),
        identity(identity_),
        description(description_of(info)),
        header(make_header(identity_, description)),
        codec(header) {
    if (fresh)
      create(0, {});
    else
      open_existing(carry, visit);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() = default;

  void open_existing(const Carry& carry, const Visit& visit);
  void create(std::uint64_t count, const RowOf& row);
  void create(const std::vector<Row>& rows, const Visit& visit);
  bool replace(const JournalHeader& old, const Carry& carry, const Visit& visit);
  int write(int fd, std::span<const Row> rows);
  void cut_behind_last_whole_record();
  void check() const;
  std::uint64_t end() const { return first_record(header) + records * codec.size(); }
  [[noreturn]] void fail(const char* what, int error) const {
    throw IoError(fmt::format("cannot {} {}: {}", what, path, reason(error)));
  }

  TableLock lock;  // first in, last out
  std::string path;
  JournalIdentity identity;
  std::string description;
  JournalHeader header;  // of the file, once there is one
  RecordCodec codec;
  File file;
  std::unique_ptr<BackgroundSync> syncing;  // of the file, once something is written
  std::vector<std::byte> buffer;            // the records of one write
  std::uint64_t records = 0;                // in the file, damaged ones included
  std::string failure;                      // why nothing can be written any more
  std::uint64_t dropped = 0;
};

void Journal::Impl::open_existing(const Carry& carry, const Visit& visit) {
  file = File(path, O_RDWR | O_NOFOLLOW | O_NONBLOCK);
  if (!file.is_open() && errno == ENOENT) return;
  if (!file.is_open() && errno == ELOOP) require_plain(path);
  if (!file.is_open()) throw OutputError(fmt::format("cannot open {}: {}", path, reason(errno)));
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0) fail("read", errno);
  JournalHeader found;
  std::size_t size = 0;
  if (S_ISREG(status.st_mode)) size = read_at(file.fd(), std::as_writable_bytes(std::span(&found, 1)), 0, path);
  const std::string why = why_unusable(found, size, identity);
  const bool same_but_for_the_sweep =
      why_unusable(found, size, {found.spec_hash, identity.physics_version, found.rows}).empty();
  if (!why.empty() && carry && same_but_for_the_sweep && replace(found, carry, visit)) return;
  if (!why.empty())
    throw OutputError(fmt::format(
        "{} {}. {}tart the sweep again with --fresh, which replaces it, or choose another "
        "output with -o",
        path, why, same_but_for_the_sweep ? "Go on with --extend, which keeps the rows that are the same, s" : "S"));
  if (!read_description(file, path, found)) return create(recover_rows(file, path, found), visit);  // damaged
  const RecoveredRecords recovered = recover_records(file, path, found, visit);
  records = recovered.records;
  dropped = recovered.dropped;
  header = found;
  codec = RecordCodec(header);
  if (::ftruncate(file.fd(), static_cast<off_t>(end())) != 0) fail("cut the torn end of", errno);
}

/// Returns false, and leaves everything as it was, where carry() refuses.
bool Journal::Impl::replace(const JournalHeader& old, const Carry& carry, const Visit& visit) {
  const auto text = read_description(file, path, old);
  const auto taken = carry(recover_rows(file, path, old), text ? parse_description(*text) : std::nullopt);
  if (taken) create(*taken, visit);
  return taken.has_value();
}

void Journal::Impl::create(const std::vector<Row>& rows, const Visit& visit) {
  create(rows.size(), [&](std::uint64_t k) { return rows[k]; });
  std::ranges::for_each(rows, visit);
}

/// Makes a journal that begins with these rows. It appears complete: a journal always has a whole header.
void Journal::Impl::create(std::uint64_t count, const RowOf& row) {
  require_plain(path);
  AtomicFile made(path);
  records = 0;
  int error = write_at(made.fd(), std::as_bytes(std::span(&header, 1)), 0);
  if (error == 0) error = write_at(made.fd(), std::as_bytes(std::span(description)), sizeof header);
  std::vector<Row> some;
  for (std::uint64_t k = 0; error == 0 && k < count; ++k) {
    some.push_back(row(k));
    if (some.size() == rows_at_a_time || k + 1 == count) error = write(made.fd(), std::exchange(some, {}));
  }
  if (error == 0) error = made.sync();
  if (error == 0) error = made.rename();
  if (error != 0) throw OutputError(fmt::format("cannot create {}: {}", path, reason(error)));
  file = made.release();
  sync_directory_of(path);
}

/// Appends the rows in one write. Returns 0, or the errno of a failure; `records` then is as before.
int Journal::Impl::write(int fd, std::span<const Row> rows) {
  buffer.resize(rows.size() * codec.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    assert(rows[i].index < identity.rows);
    codec.encode(rows[i], records + i, buffer.data() + i * codec.size());
  }
  const int error = write_at(fd, buffer, end());
  if (error == 0) records += rows.size();
  return error;
}

/// After a write that failed: what of it went through stays.
void Journal::Impl::cut_behind_last_whole_record() {
  struct stat status {};
  const bool is_known = ::fstat(file.fd(), &status) == 0;
  if (const auto size = static_cast<std::uint64_t>(status.st_size); is_known && size > end())
    records += (size - end()) / codec.size();
  if (!is_known || ::ftruncate(file.fd(), static_cast<off_t>(end())) != 0)
    failure = fmt::format("cannot write {}: {}", path, reason(errno));
}

void Journal::Impl::check() const {
  if (!failure.empty()) throw IoError(failure);
  if (syncing && syncing->failure() != 0)
    throw IoError(fmt::format("cannot sync {}: {}", path, reason(syncing->failure())));
}

Journal::Journal(const std::string& table_path, const JournalIdentity& identity, bool fresh, const Carry& carry,
                 const TableInfo& info, const Visit& visit)
    : impl_(std::make_unique<Impl>(table_path, identity, fresh, carry, info, visit)) {}

Journal::~Journal() = default;
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;

bool Journal::is_locked_by_file() const { return impl_->lock.is_by_owner_file(); }
bool Journal::is_there() const { return impl_->file.is_open(); }

void Journal::begin(std::uint64_t count, const RowOf& row) {
  if (!is_there()) return impl_->create(count, row);
  for (std::uint64_t k = 0; k < count; ++k) append(row(k));
}

std::vector<Row> Journal::recovered() const {
  return is_there() ? recover_rows(impl_->file, impl_->path, impl_->header) : std::vector<Row>();
}
std::uint64_t Journal::dropped() const { return impl_->dropped; }

void Journal::append(std::span<const Row> rows) {
  Impl& j = *impl_;
  j.check();
  if (rows.empty()) return;
  if (!is_there()) j.create(0, {});
  if (!j.syncing) j.syncing = std::make_unique<BackgroundSync>(j.file.fd());
  const int error = j.write(j.file.fd(), rows);
  j.syncing->wrote();
  if (error == 0) return;
  j.cut_behind_last_whole_record();
  j.fail("write", error);
}

void Journal::sync() {
  if (impl_->syncing) impl_->syncing->sync();
  impl_->check();
}

void Journal::check() const { impl_->check(); }

void Journal::remove() {
  Impl& j = *impl_;
  j.failure = fmt::format("{} was removed", j.path);
  j.syncing.reset();
  j.file.close();
  if (::unlink(j.path.c_str()) != 0 && errno != ENOENT) j.fail("remove", errno);
  sync_directory_of(j.path);
}

}  // namespace sigmasweep
