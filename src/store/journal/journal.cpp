#include "store/journal/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <chrono>
#include <span>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/journal/description.hpp"
#include "store/journal/lock.hpp"
#include "store/journal/record.hpp"
#include "store/journal/recover.hpp"

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;

// Group commit: one fdatasync per record would allow some hundred rows/s, one per 1024 records some hundred thousand.
constexpr std::uint64_t records_per_sync = 1024;
constexpr auto time_per_sync = std::chrono::seconds(1);

}  // namespace

struct Journal::Impl {
  Impl(const std::string& table_path, const JournalIdentity& identity_, bool fresh, const Carry& carry,
       const TableInfo& info)
      : lock(table_path),
        path(beside(table_path, ".journal")),
        identity(identity_),
        description(description_of(info)),
        header(make_header(identity_, description)),
        codec(header),
        buffer(codec.size()) {
    if (fresh)
      create({});
    else
      open_existing(carry);
  }
  ~Impl() {
    if (file.is_open() && failure.empty() && unsynced != 0) ::fdatasync(file.fd());  // nobody left to tell
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void open_existing(const Carry& carry);
  void create(const std::vector<Row>& rows);
  void recover(const JournalHeader& found);
  bool replace(const JournalHeader& old, const Carry& carry);
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
  std::vector<std::byte> buffer;  // one record
  std::uint64_t records = 0;      // in the file, damaged ones included
  std::uint64_t unsynced = 0;
  Clock::time_point last_sync = Clock::now();
  std::string failure;  // why nothing can be written any more
  std::vector<Row> recovered;
  std::uint64_t dropped = 0;
};

void Journal::Impl::open_existing(const Carry& carry) {
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
  if (!why.empty() && carry && same_but_for_the_sweep && replace(found, carry)) return;
  if (!why.empty())
    throw OutputError(fmt::format(
        "{} {}. {}tart the sweep again with --fresh, which replaces it, or choose another "
        "output with -o",
        path, why, same_but_for_the_sweep ? "Go on with --extend, which keeps the rows that are the same, s" : "S"));
  recover(found);
  if (!read_description(file, path, found)) return create(recovered);  // damaged: the rows are not
  header = found;
  codec = RecordCodec(header);
  if (::ftruncate(file.fd(), static_cast<off_t>(end())) != 0) fail("cut the torn end of", errno);
}

/// Returns false, and leaves everything as it was, where carry() refuses.
bool Journal::Impl::replace(const JournalHeader& old, const Carry& carry) {
  const auto text = read_description(file, path, old);
  recover(old);
  auto taken = carry(recovered, text ? parse_description(*text) : std::nullopt);
  if (!taken) return false;
  recovered = *std::move(taken);
  dropped = 0;
  create(recovered);
  return true;
}

/// Makes a journal that begins with these rows. It appears complete: a journal always has a whole header.
void Journal::Impl::create(const std::vector<Row>& rows) {
  require_plain(path);
  AtomicFile made(path);
  records = 0;
  int error = write_at(made.fd(), std::as_bytes(std::span(&header, 1)), 0);
  if (error == 0) error = write_at(made.fd(), std::as_bytes(std::span(description)), sizeof header);
  for (const Row& row : rows) {
    if (error != 0) break;
    codec.encode(row, records, buffer.data());
    error = write_at(made.fd(), buffer, end());
    ++records;
  }
  if (error == 0) error = made.sync();
  if (error == 0) error = made.rename();
  if (error != 0) throw OutputError(fmt::format("cannot create {}: {}", path, reason(error)));
  file = made.release();
  sync_directory_of(path);
}

/// Sets `records` to one past the last good record.
void Journal::Impl::recover(const JournalHeader& found) {
  RecoveredRows all = recover_rows(file, path, found);
  recovered = std::move(all.rows);
  records = all.records;
  dropped = all.dropped;
}

Journal::Journal(const std::string& table_path, const JournalIdentity& identity, bool fresh, const Carry& carry,
                 const TableInfo& info)
    : impl_(std::make_unique<Impl>(table_path, identity, fresh, carry, info)) {}

Journal::~Journal() = default;
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;

bool Journal::is_locked_by_file() const { return impl_->lock.is_by_owner_file(); }
bool Journal::is_there() const { return impl_->file.is_open(); }

void Journal::begin(const std::vector<Row>& rows) {
  if (!is_there()) return impl_->create(rows);
  for (const Row& row : rows) append(row);
}

const std::vector<Row>& Journal::recovered() const { return impl_->recovered; }
std::uint64_t Journal::dropped() const { return impl_->dropped; }

void Journal::append(const Row& row) {
  Impl& j = *impl_;
  assert(row.index < j.identity.rows);
  if (!j.failure.empty()) throw IoError(j.failure);
  if (!is_there()) j.create({});
  j.codec.encode(row, j.records, j.buffer.data());
  if (const int error = write_at(j.file.fd(), j.buffer, j.end()); error != 0) {
    if (::ftruncate(j.file.fd(), static_cast<off_t>(j.end())) != 0)
      j.failure = fmt::format("cannot write {}: {}", j.path, reason(error));
    j.fail("write", error);
  }
  ++j.records;
  ++j.unsynced;
  if (j.unsynced >= records_per_sync || Clock::now() - j.last_sync >= time_per_sync) sync();
}

void Journal::sync() {
  Impl& j = *impl_;
  if (!j.failure.empty()) throw IoError(j.failure);
  if (j.unsynced == 0) return;
  if (::fdatasync(j.file.fd()) != 0) {
    // The kernel may have dropped the pages and forgotten the error: a second try could succeed without them.
    j.failure = fmt::format("cannot sync {}: {}", j.path, reason(errno));
    throw IoError(j.failure);
  }
  j.unsynced = 0;
  j.last_sync = Clock::now();
}

void Journal::sync_if_due() {
  if (impl_->unsynced != 0 && impl_->failure.empty() && Clock::now() - impl_->last_sync >= time_per_sync) sync();
}

void Journal::remove() {
  Impl& j = *impl_;
  j.failure = fmt::format("{} was removed", j.path);
  j.file.close();
  if (::unlink(j.path.c_str()) != 0 && errno != ENOENT) j.fail("remove", errno);
  sync_directory_of(j.path);
}

}  // namespace sigmasweep
