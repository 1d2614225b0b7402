#include "store/journal/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "store/journal/lock.hpp"
#include "store/journal/open.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t rows_at_a_time = 4096;  // of a journal that is made
constexpr std::chrono::milliseconds patience(10'000), look_every(50);

void wait_for_lock(const File& file, const std::string& path) {
  for (const auto end = std::chrono::steady_clock::now() + patience; !lock_whole_file(file);) {
    if (std::chrono::steady_clock::now() >= end)
      throw OutputError(fmt::format("another process still has {}: is it a rank of an earlier run?", path));
    std::this_thread::sleep_for(look_every);
  }
}

std::uint64_t whole_records(const File& file, const JournalHeader& header, const std::string& path) {
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0) throw IoError(fmt::format("cannot read {}: {}", path, reason(errno)));
  const auto size = static_cast<std::uint64_t>(status.st_size), first = first_record(header);
  return size < first ? 0 : (size - first) / header.record_size;
}

}  // namespace

JournalFile::JournalFile(std::string path, const JournalIdentity& identity, const TableInfo& info)
    : path_(std::move(path)),
      description_(description_of({info, {identity.results.begin(), identity.results.end()}})),
      results_(identity.results.begin(), identity.results.end()),
      rows_(identity.rows),
      header_(make_header(identity, description_)),
      codec_(header_, record_fields(header_, results_).value()) {}

void JournalFile::fail(const char* what, int error) const {
  throw IoError(fmt::format("cannot {} {}: {}", what, path_, reason(error)));
}

void JournalFile::create(std::uint64_t count, const RowOf& row) {
  make(count, [&](std::uint64_t k) {
    const Row made = row(k);
    encode(made, content_key(made.parameters));
  });
}

void JournalFile::create(std::span<const JournalledRow> rows) {
  make(rows.size(), [&](std::uint64_t k) { encode(rows[k].row, rows[k].content_key); });
}

void JournalFile::make(std::uint64_t count, const Encode& encode_row) {
  require_plain(path_);
  AtomicFile made(path_);
  records_ = 0;
  int error = write_at(made.fd(), std::as_bytes(std::span(&header_, 1)), 0);
  if (error == 0) error = write_at(made.fd(), std::as_bytes(std::span(description_)), sizeof header_);
  for (std::uint64_t k = 0; error == 0 && k < count; ++k) {
    encode_row(k);
    if ((k + 1) % rows_at_a_time == 0 || k + 1 == count) error = write(made.fd());
  }
  if (error == 0) error = made.sync();
  if (error == 0) error = made.rename();
  if (error != 0) throw OutputError(fmt::format("cannot create {}: {}", path_, reason(error)));
  file_ = made.release();
  sync_directory_of(path_);
}

void JournalFile::go_on(File file, const JournalHeader& header, std::uint64_t records) {
  file_ = std::move(file);
  header_ = header;
  codec_ = RecordCodec(header_, record_fields(header_, results_).value());
  records_ = records;
  if (::ftruncate(file_.fd(), static_cast<off_t>(end())) != 0) fail("cut the torn end of", errno);
}

void JournalFile::begin_alone() {
  OpenJournal found = open_journal(path_, O_RDWR);
  if (!found.is_there() && found.error != ENOENT) {
    if (found.error == ELOOP) require_plain(path_);
    throw OutputError(fmt::format("cannot open {}: {}", path_, reason(found.error)));
  }
  if (found.is_there() && !found.is_ours())
    throw OutputError(fmt::format(
        "{} is not a journal of sigmasweep. Choose another output with -o, or --fresh to replace it", path_));
  const bool goes_on = found.is_there() && is_of_same_sweep(found.header, header_) &&
                       found.header.format_version == journal_format_version && found.why_unreadable(results_).empty();
  if (goes_on) {
    wait_for_lock(found.file, path_);
    const std::uint64_t records = whole_records(found.file, found.header, path_);
    return go_on(std::move(found.file), found.header, records);
  }
  create(0, RowOf());
  wait_for_lock(file_, path_);
}

/// Adds a record to the next write.
void JournalFile::encode(const Row& row, std::uint64_t key) {
  assert(row.index < rows_);
  const std::size_t size = codec_.size(), there = buffer_.size();
  buffer_.resize(there + size);
  codec_.encode(row, key, records_ + there / size, buffer_.data() + there);
}

/// Appends what was encoded in one write. Returns 0, or the errno of a failure; `records_` then is as before.
int JournalFile::write(int fd) {
  const int error = write_at(fd, buffer_, end());
  if (error == 0) records_ += buffer_.size() / codec_.size();
  buffer_.clear();
  return error;
}

/// After a write that failed: what of it went through stays.
void JournalFile::cut_behind_last_whole_record() {
  struct stat status {};
  const bool is_known = ::fstat(file_.fd(), &status) == 0;
  if (const auto size = static_cast<std::uint64_t>(status.st_size); is_known && size > end())
    records_ += (size - end()) / codec_.size();
  if (!is_known || ::ftruncate(file_.fd(), static_cast<off_t>(end())) != 0)
    failure_ = fmt::format("cannot write {}: {}", path_, reason(errno));
}

void JournalFile::check() const {
  if (!failure_.empty()) throw IoError(failure_);
  if (syncing_ && syncing_->failure() != 0)
    throw IoError(fmt::format("cannot sync {}: {}", path_, reason(syncing_->failure())));
}

void JournalFile::append(std::span<const Row> rows) {
  check();
  if (rows.empty()) return;
  if (!syncing_) syncing_ = std::make_unique<BackgroundSync>(file_.fd());
  for (const Row& row : rows) encode(row, content_key(row.parameters));
  const int error = write(file_.fd());
  syncing_->wrote();
  if (error == 0) return;
  cut_behind_last_whole_record();
  fail("write", error);
}

void JournalFile::sync() {
  if (syncing_) syncing_->sync();
  check();
}

void JournalFile::remove() {
  failure_ = fmt::format("{} was removed", path_);
  syncing_.reset();
  file_.close();
  if (::unlink(path_.c_str()) != 0 && errno != ENOENT) fail("remove", errno);
  sync_directory_of(path_);
}

}  // namespace sigmasweep
