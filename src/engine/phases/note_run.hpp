#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "engine/phases/open.hpp"
#include "engine/report/reporter.hpp"
#include "mpi/world.hpp"
#include "store/run_notes/run_notes.hpp"

namespace sigmasweep {

/// Third phase, which lasts until the table is written: the notes of a run are there, for the next run, which then
/// knows which rows this one died of, and for everybody who looks at the run. Rows during which processes died in
/// earlier runs are quarantined.
class NotedRun {
 public:
  /// Collective. Throws OutputError and IoError.
  NotedRun(const World& world, OpenSweep& open, const Reporter& reporter);
  /// On the manager, removes the notes.
  ~NotedRun();
  NotedRun(const NotedRun&) = delete;
  NotedRun& operator=(const NotedRun&) = delete;
  /// Those of this rank.
  RunNotes& notes() { return *notes_; }
  /// Rows that were being computed when a process died, and are not done; on each rank.
  const std::set<std::uint64_t>& suspects() const { return suspects_; }

 private:
  const OpenSweep& open_;
  bool is_manager_;
  std::set<std::uint64_t> suspects_;
  std::optional<RunNotes> notes_;
};

}  // namespace sigmasweep
