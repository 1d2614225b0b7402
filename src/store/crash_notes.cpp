#include "store/crash_notes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <span>
#include <thread>
#include <vector>

#include "base/atomic_file.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

// The file is an array of 64-bit numbers: a header of one cache line; a cache line for each rank, which begins with the
// rank's row + 1, or 0; and then pairs of a row and its suspicion score.
constexpr std::size_t line = 8;
constexpr std::uint64_t magic = 0x0a314e5552575353;  // "SSWRUN1\n" on a little-endian machine
enum Header : std::size_t { is_magic, spec_hash, rows, run, ranks };
constexpr std::uint64_t max_numbers = 1 << 24;

std::string name_of(const std::string& table) { return table + ".running"; }

/// The numbers of the file; none if the file is not of this format.
std::vector<std::uint64_t> read_numbers(const std::string& path) {
  const File file(path, O_RDONLY);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.fd(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size < line * sizeof(std::uint64_t) || size > max_numbers * sizeof(std::uint64_t)) return {};
  std::vector<std::uint64_t> numbers(size / sizeof(std::uint64_t));
  const auto bytes = std::as_writable_bytes(std::span(numbers));
  if (read_at(file.fd(), bytes, 0, path) != bytes.size() || numbers[is_magic] != magic) return {};
  if (numbers[ranks] >= numbers.size() / line) return {};
  return numbers;
}

SuspicionByRow suspicion_in(const std::vector<std::uint64_t>& numbers, const CrashNotesIdentity& identity) {
  SuspicionByRow suspicion;
  if (numbers.empty() || numbers[spec_hash] != identity.spec_hash || numbers[rows] != identity.rows) return suspicion;
  const std::size_t past = line * (1 + numbers[ranks]);
  for (std::size_t i = past; i + 1 < numbers.size(); i += 2)
    if (numbers[i] < identity.rows) suspicion[numbers[i]] += numbers[i + 1];
  std::vector<std::uint64_t> left;
  for (std::size_t i = line; i < past; i += line)
    if (numbers[i] > 0 && numbers[i] <= identity.rows) left.push_back(numbers[i] - 1);
  for (const std::uint64_t row : left) suspicion[row] += left.size() == 1 ? 2 : 1;
  return suspicion;
}

}  // namespace

SuspicionByRow begin_crash_notes(const std::string& table, const CrashNotesIdentity& identity, int rank_count,
                                 bool fresh) {
  const std::string path = name_of(table);
  SuspicionByRow suspicion;
  if (!fresh) suspicion = suspicion_in(read_numbers(path), identity);
  std::vector<std::uint64_t> numbers(line * (1 + static_cast<std::size_t>(rank_count)));
  numbers[is_magic] = magic;
  numbers[spec_hash] = identity.spec_hash;
  numbers[rows] = identity.rows;
  numbers[run] = identity.run;
  numbers[ranks] = static_cast<std::uint64_t>(rank_count);
  for (const auto& [row, score] : suspicion) numbers.insert(numbers.end(), {row, score});
  AtomicFile file(path);
  int error = write_at(file.fd(), std::as_bytes(std::span(numbers)), 0);
  if (error == 0) error = file.rename();
  if (error != 0) throw OutputError(fmt::format("cannot create {}: {}", path, reason(error)));
  return suspicion;
}

void end_crash_notes(const std::string& table, bool complete) noexcept {
  try {
    const std::string path = name_of(table);
    const auto numbers = read_numbers(path);
    if (complete || numbers.empty() || numbers.size() == line * (1 + numbers[ranks])) ::unlink(path.c_str());
  } catch (...) {  // out of memory; a file that is left does no harm
  }
}

CrashNotes::CrashNotes(const std::string& table, const CrashNotesIdentity& identity, int rank) {
  const std::string path = name_of(table);
  // Another host may see a new file a moment later.
  for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);;) {
    const auto numbers = read_numbers(path);
    if (!numbers.empty() && numbers[run] == identity.run) {
      size_ = numbers.size() * sizeof(std::uint64_t);
      break;
    }
    if (std::chrono::steady_clock::now() >= end)
      throw OutputError(
          fmt::format("rank {} does not find {}, which rank 0 has made. All ranks need the same file "
                      "system",
                      rank, path));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const File file(path, O_RDWR);
  if (!file.is_open())
    throw OutputError(fmt::format("rank {} cannot write {}, which rank 0 has made: {}", rank, path, reason(errno)));
  memory_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, file.fd(), 0);
  if (memory_ == MAP_FAILED) memory_ = nullptr;
  if (memory_) slot_ = static_cast<std::uint64_t*>(memory_) + line * (1 + static_cast<std::size_t>(rank));
}

CrashNotes::~CrashNotes() {
  if (memory_) ::munmap(memory_, size_);
}

void CrashNotes::begin(std::uint64_t row) noexcept {
  if (slot_) std::atomic_ref(*slot_).store(row + 1);
  if (absolved_) end();  // asked afterwards, because absolve() may come at any moment
}

void CrashNotes::end() noexcept {
  if (slot_) std::atomic_ref(*slot_).store(0);
}

void CrashNotes::absolve() noexcept {
  if (!absolved_.exchange(true)) end();
}

}  // namespace sigmasweep
