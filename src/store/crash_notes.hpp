#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <string>

namespace sigmasweep {

/// Crash notes say which row each rank is computing. They stand in a file beside the table (TABLE.h5.running) that
/// outlives a process that dies, so that the next run knows which rows were being computed then. The file is mapped
/// into memory: a note costs a nanosecond, and survives the process, though not the machine. Only the quarantine
/// depends on crash notes; a foreign or damaged file is ignored.
///
/// A CrashNotesIdentity tells to which sweep and run a file belongs.
struct CrashNotesIdentity {
  std::uint64_t spec_hash = 0, rows = 0;
  std::uint64_t run = 0;  ///< a random number, to know the file again on another host
};

/// Suspicion score of each row that was being computed when a process died. The score of a row rises by 2 for each run
/// that died while no other row was being computed, and by 1 where there were others: then any of these rows, mpirun or
/// the machine may have been the cause.
using SuspicionByRow = std::map<std::uint64_t, std::uint64_t>;

/// Returns the suspicion scores that earlier runs left (none if `fresh`), and makes a new file for `ranks` ranks that
/// keeps these scores. On the manager, before any rank makes its CrashNotes. Throws OutputError.
SuspicionByRow begin_crash_notes(const std::string& table, const CrashNotesIdentity& identity, int ranks, bool fresh);
/// Removes the file if it holds no suspicion, or if all rows are there. On the manager, after all ranks have finished.
void end_crash_notes(const std::string& table, bool complete) noexcept;

/// The crash notes of one rank.
class CrashNotes {
 public:
  /// Throws OutputError if the file that the manager made is not there: this rank does not see the same directory.
  CrashNotes(const std::string& table, const CrashNotesIdentity& identity, int rank);
  ~CrashNotes();
  CrashNotes(const CrashNotes&) = delete;
  CrashNotes& operator=(const CrashNotes&) = delete;
  void begin(std::uint64_t row) noexcept;
  void end() noexcept;
  /// This rank was told to stop: if it dies from now on, its row is not the cause. May be called from any thread, and
  /// repeatedly.
  void absolve() noexcept;

 private:
  void* memory_ = nullptr;  ///< null where files cannot be mapped: no notes
  std::size_t size_ = 0;
  std::uint64_t* slot_ = nullptr;
  std::atomic<bool> absolved_ = false;
};

}  // namespace sigmasweep
