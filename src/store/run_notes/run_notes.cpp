#include "store/run_notes/run_notes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <span>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "store/run_notes/contents.hpp"

namespace sigmasweep {
namespace {

/// The rows that a rank was computing.
std::vector<std::uint64_t> rows_of(const notes::RankPage& page) {
  if (page.row_plus_1 == 0) return {};
  if (page.batch == 0) return {page.row_plus_1 - 1};
  return {page.rows.begin(), page.rows.begin() + std::min(page.batch, notes::max_noted_rows)};
}

/// The suspicion that the file of an earlier run gives rise to, if it is of the same sweep.
SuspicionByRow suspicion_in(const notes::Contents& found, const RunNotesIdentity& identity) {
  SuspicionByRow suspicion;
  if (found.header.spec_hash != identity.spec_hash || found.header.rows != identity.rows) return suspicion;
  for (const auto& [row, score] : found.suspicions)
    if (row < identity.rows) suspicion[row] += score;
  std::vector<std::uint64_t> left;
  for (const notes::RankPage& page : found.ranks)
    for (const std::uint64_t row : rows_of(page))
      if (row < identity.rows) left.push_back(row);
  for (const std::uint64_t row : left) suspicion[row] += left.size() == 1 ? 2 : 1;
  return suspicion;
}

/// The header that the manager made. Another host may see a new file a moment later.
notes::Header wait_for_header(const std::string& path, const RunNotesIdentity& identity, int rank) {
  for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);;) {
    if (const auto found = notes::read(path); found && found->header.run == identity.run) return found->header;
    if (std::chrono::steady_clock::now() >= end)
      throw OutputError(
          fmt::format("rank {} does not find {}, which rank 0 has made. All ranks need the same file "
                      "system",
                      rank, path));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

template <class Number>
void store(Number& target, Number value) noexcept {
  std::atomic_ref(target).store(value, std::memory_order_relaxed);
}

}  // namespace

SuspicionByRow begin_run_notes(const std::string& table, const RunNotesIdentity& identity, int rank_count, bool fresh) {
  const std::string path = notes::path_of(table);
  SuspicionByRow suspicion;
  if (const auto left = fresh ? std::nullopt : notes::read(path)) suspicion = suspicion_in(*left, identity);
  notes::Contents made;
  made.header.spec_hash = identity.spec_hash;
  made.header.rows = identity.rows;
  made.header.run = identity.run;
  made.header.ranks = static_cast<std::uint64_t>(rank_count);
  made.header.page_size = std::max<std::uint64_t>(notes::min_page_size, ::sysconf(_SC_PAGESIZE));
  made.header.suspected = suspicion.size();
  made.header.seconds_left = RunProgress{}.seconds_left;
  for (const auto& [row, score] : suspicion) made.suspicions.push_back({row, score});
  notes::write(path, made);
  return suspicion;
}

void end_run_notes(const std::string& table, bool complete) noexcept {
  try {
    const std::string path = notes::path_of(table);
    auto found = notes::read(path);
    if (!found) return;
    if (complete || found->suspicions.empty()) {
      ::unlink(path.c_str());
      return;
    }
    found->header.ranks = 0;
    found->ranks.clear();
    notes::write(path, *found);
  } catch (...) {  // out of memory, a full disk; a file that is left does no harm
  }
}

double heartbeat_period(std::uint64_t ranks) { return std::clamp(static_cast<double>(ranks) / 200.0, 1.0, 10.0); }

RunNotes::RunNotes(const std::string& table, const RunNotesIdentity& identity, int rank) {
  const std::string path = notes::path_of(table);
  const notes::Header header = wait_for_header(path, identity, rank);
  file_ = File(path, O_RDWR | O_NOFOLLOW);
  if (!file_.is_open())
    throw OutputError(fmt::format("rank {} cannot write {}, which rank 0 has made: {}", rank, path, reason(errno)));
  map(header.page_size, rank);
  page_->process = this_process();
  page_->machine = this_machine();
  ::gethostname(page_->host.data(), page_->host.size() - 1);
  if (header_ && !mapped_) *header_ = header;
  beat();
  const double period = rank == 0 ? heartbeat_period(1) : heartbeat_period(header.ranks);
  heart_ = std::jthread([this, period](const std::stop_token& stop) { keep_beating(stop, period); });
}

/// Takes this rank's page, on the manager also the header before it.
void RunNotes::map(std::uint64_t page_size, int rank) {
  const bool is_manager = rank == 0;
  offset_ = is_manager ? 0 : page_size * (1 + static_cast<std::uint64_t>(rank));
  size_ = is_manager ? 2 * page_size : page_size;
  mapped_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, file_.fd(), static_cast<off_t>(offset_));
  if (mapped_ == MAP_FAILED) {
    mapped_ = nullptr;
    copy_ = std::make_unique<std::byte[]>(size_);
  }
  std::byte* const begin = mapped_ ? static_cast<std::byte*>(mapped_) : copy_.get();
  if (is_manager) header_ = reinterpret_cast<notes::Header*>(begin);
  page_ = reinterpret_cast<notes::RankPage*>(begin + size_ - page_size);
}

RunNotes::~RunNotes() {
  heart_.request_stop();
  heart_.join();
  if (!mapped_) beat();  // what the last notes were
  if (mapped_) ::munmap(mapped_, size_);
}

void RunNotes::keep_beating(const std::stop_token& stop, double period) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any ending;
  while (!stop.stop_requested()) {
    ending.wait_for(lock, stop, std::chrono::duration<double>(period), [] { return false; });
    beat();
  }
}

/// A page that a local file system has in memory is seen by its other processes at once. Writing it out makes it seen
/// by other machines, too; nothing waits for that.
void RunNotes::beat() noexcept {
  store(page_->beat, monotonic_nanoseconds());
  if (mapped_)
    ::sync_file_range(file_.fd(), static_cast<off_t>(offset_), static_cast<off_t>(size_), SYNC_FILE_RANGE_WRITE);
  else
    write_at(file_.fd(), std::span(copy_.get(), size_), offset_);
}

void RunNotes::begin(std::span<const std::uint64_t> rows, Clock::time_point since) noexcept {
  store(page_->began, std::int64_t{std::chrono::nanoseconds(since.time_since_epoch()).count()});
  std::atomic_ref batch(page_->batch);
  batch.store(0);
  std::atomic_ref(page_->row_plus_1).store(rows.front() + 1);
  if (rows.size() > 1) {
    const auto noted = rows.first(std::min<std::size_t>(rows.size(), notes::max_noted_rows));
    std::ranges::copy(noted, page_->rows.begin());
    batch.store(noted.size());
  }
  if (absolved_) end();  // asked afterwards, because absolve() may come at any moment
}

void RunNotes::end() noexcept { std::atomic_ref(page_->row_plus_1).store(0); }

void RunNotes::absolve() noexcept {
  if (!absolved_.exchange(true)) end();
}

void RunNotes::tell(const RunProgress& progress) noexcept {
  if (!header_) return;
  store(header_->done, progress.done);
  store(header_->seconds, progress.seconds);
  store(header_->seconds_left, progress.seconds_left);
}

}  // namespace sigmasweep
