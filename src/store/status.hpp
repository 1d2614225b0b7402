#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "store/run_notes/look.hpp"
#include "store/stored/stored_rows.hpp"

namespace sigmasweep {

/// How far a sweep is, and what its run does at the moment.
struct SweepStatus {
  StoredRows stored;              ///< the rows that are there
  std::optional<RunState> run{};  ///< of a sweep that runs or was killed: its notes

  bool is_running() const { return !stored.complete && run && run->is_running; }
  /// "running", "stopped" (on purpose, or killed) or "complete".
  std::string_view state() const;
  /// Of a running sweep.
  std::optional<double> rows_per_second() const;
  std::optional<double> seconds_left() const;
};

/// Looks at a sweep that runs, was stopped, was killed or is finished, from any machine that shares the file system;
/// without a lock, and without a change to any file. Takes up to `patience` where heartbeats alone can tell whether the
/// sweep runs. Throws as read_stored_rows().
SweepStatus status_of_sweep(const std::string& table, std::chrono::milliseconds patience = std::chrono::seconds(5));

}  // namespace sigmasweep
