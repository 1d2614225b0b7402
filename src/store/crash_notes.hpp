#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <string>

namespace sigmasweep {

/// Which row each rank is computing, in a file beside the table (TABLE.h5.running) that is still there when the process
/// is not: so the next run knows what it died of. The file is mapped into memory: a note costs a nanosecond, and
/// outlives the process, though not the machine. Nothing but the quarantine hangs on it; a foreign or damaged file is
/// taken for none.
struct CrashNotesIdentity {
  std::uint64_t spec_hash = 0, rows = 0;
  std::uint64_t run = 0;  ///< a random number, to know the file again on another host
};

/// What speaks for it that a row kills its process, by row: 2 for each run that died while it was the only one in
/// flight; 1 where others were as well, as it may have been any of them, or mpirun or the machine that died.
using SuspicionByRow = std::map<std::uint64_t, std::uint64_t>;

/// On the manager, before anybody notes: what earlier runs left (nothing if `fresh`), and a new file for
/// `ranks` ranks that remembers it. Throws OutputError.
SuspicionByRow begin_crash_notes(const std::string& table, const CrashNotesIdentity& identity, int ranks, bool fresh);
/// On the manager, once nobody notes any more: the file goes if it has nothing to remember, or if all rows are there.
void end_crash_notes(const std::string& table, bool complete) noexcept;

/// One rank's notes.
class CrashNotes {
 public:
  /// Throws OutputError if the file that the manager made is not there: this rank does not see the same directory.
  CrashNotes(const std::string& table, const CrashNotesIdentity& identity, int rank);
  ~CrashNotes();
  CrashNotes(const CrashNotes&) = delete;
  CrashNotes& operator=(const CrashNotes&) = delete;
  void begin(std::uint64_t row) noexcept;
  void end() noexcept;
  /// This rank was told to stop: whatever it dies of now, it is not the row. From any thread, as often as you like.
  void absolve() noexcept;

 private:
  void* memory_ = nullptr;  ///< null where files cannot be mapped: no notes
  std::size_t size_ = 0;
  std::uint64_t* slot_ = nullptr;
  std::atomic<bool> excused_ = false;
};

}  // namespace sigmasweep
