#pragma once

#include <optional>

#include "engine/phases/note_run.hpp"
#include "engine/phases/open.hpp"
#include "engine/report/summary.hpp"
#include "engine/stop/deadline.hpp"
#include "engine/stop/stop.hpp"

namespace sigmasweep {

/// The result of the fourth phase.
struct Computed {
  bool is_complete = false;   ///< all rows of the sweep are there now
  Work work{};                ///< on the manager
  double wall_seconds = 0.0;  ///< time that the computing took
};

/// Fourth phase: computes the rows that are missing, on all ranks; each goes to the journal of its rank.
/// Ends early when `stop` says so on any rank, and begins no row that is not expected to end before `deadline`. Each
/// rank tells in its notes what it does. Throws OutputError and IoError.
Computed compute_rows(const World& world, OpenSweep& open, NotedRun& noted, std::optional<Deadline>& deadline,
                      const StopRequest& stop, const Reporter& reporter);

}  // namespace sigmasweep
