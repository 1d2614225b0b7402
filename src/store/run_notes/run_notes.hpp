#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include "base/file.hpp"

namespace sigmasweep {

/// Run notes say which row each rank is computing, and that it lives. They stand in a file beside the table
/// (TABLE.h5.running). The file outlives a process that dies, so that the next run knows which rows were being computed
/// then, and others can see what the run does (look_at_run()). It is mapped into memory: a note costs some nanoseconds,
/// and survives the process, though not the machine. A foreign or damaged file is ignored.
///
/// A RunNotesIdentity tells to which sweep and run a file belongs.
struct RunNotesIdentity {
  std::uint64_t spec_hash = 0, rows = 0;
  std::uint64_t run = 0;  ///< a random number, to know the file again on another host
};

/// Suspicion score of each row that was being computed when a process died. The score of a row rises by 2 for each run
/// that died while no other row was being computed, and by 1 where there were others, on other ranks or in the same
/// batch: then any of these rows, mpirun or the machine may have been the cause.
using SuspicionByRow = std::map<std::uint64_t, std::uint64_t>;

/// Returns the suspicion scores that earlier runs left (none if `fresh`), and makes a new file for `ranks` ranks that
/// keeps these scores. On the manager, before any rank makes its RunNotes. Throws OutputError.
SuspicionByRow begin_run_notes(const std::string& table, const RunNotesIdentity& identity, int ranks, bool fresh);
/// Removes the file if all rows are there; otherwise keeps the suspicion scores, if there are any. On the manager,
/// after all ranks have finished.
void end_run_notes(const std::string& table, bool complete) noexcept;

/// How far a run is.
struct RunProgress {
  std::uint64_t done = 0;                                          ///< rows that this run has finished
  double seconds = 0.0;                                            ///< since it began to compute
  double seconds_left = std::numeric_limits<double>::quiet_NaN();  ///< estimate; NaN: unknown
};

/// Seconds between the heartbeats of a rank: one; more where there are hundreds of ranks, so that their file system has
/// no more than some hundred writes a second.
double heartbeat_period(std::uint64_t ranks);

namespace notes {
struct RankPage;
struct Header;
}  // namespace notes

/// The notes of one rank. A thread beats once a second as long as the process lives, whatever the row does. Each
/// heartbeat is also handed to the file system, so that other machines see it.
class RunNotes {
 public:
  using Clock = std::chrono::steady_clock;
  /// Throws OutputError if the file that the manager made is not there: this rank does not see the same directory.
  RunNotes(const std::string& table, const RunNotesIdentity& identity, int rank);
  ~RunNotes();
  RunNotes(const RunNotes&) = delete;
  RunNotes& operator=(const RunNotes&) = delete;
  /// Rows are being computed from now on, or from a moment of the steady clock on; at most max_noted_rows are noted.
  void begin(std::uint64_t row) noexcept { begin({&row, 1}); }
  void begin(std::span<const std::uint64_t> rows, Clock::time_point since = Clock::now()) noexcept;
  void end() noexcept;
  /// This rank was told to stop: if it dies from now on, its row is not the cause. May be called from any thread, and
  /// repeatedly.
  void absolve() noexcept;
  /// Tells how far the run is. On the manager.
  void tell(const RunProgress& progress) noexcept;

 private:
  void map(std::uint64_t page_size, int rank);
  void beat() noexcept;
  void keep_beating(const std::stop_token& stop, double period);

  File file_;
  std::uint64_t offset_ = 0;  ///< of this rank's part of the file, bytes
  std::size_t size_ = 0;
  void* mapped_ = nullptr;               ///< this rank's part of the file; null where files cannot be mapped
  std::unique_ptr<std::byte[]> copy_{};  ///< then its copy, which each heartbeat writes
  notes::RankPage* page_ = nullptr;
  notes::Header* header_ = nullptr;  ///< on the manager
  std::atomic<bool> absolved_ = false;
  std::jthread heart_;  ///< last: it uses all the others
};

}  // namespace sigmasweep
