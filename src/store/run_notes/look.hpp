#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "store/run_notes/run_notes.hpp"

namespace sigmasweep {

/// What a rank does, or did when its run died.
struct RankState {
  int rank = 0;
  std::string host;
  std::optional<std::uint64_t> row{};  ///< that it computes; nothing: it waits
  std::optional<double> seconds{};     ///< how long it has computed that row
  std::optional<double> silent{};      ///< how long there was no heartbeat, if that is too long and can be known
};

/// A run as its notes show it.
struct RunState {
  bool is_running = false;
  std::string known_by;  ///< how that is known: "process 4711 is there"
  std::uint64_t spec_hash = 0;
  RunProgress progress{};
  std::vector<RankState> ranks{};
};

/// Looks at the run notes beside a table, from any machine that shares the file system; without a lock and without a
/// change to the file. Nothing if there are none, or if their run came to its end.
///
/// A run is running if one of its processes is on this machine and exists. Processes of other machines cannot be asked
/// for, and clocks of other machines may differ. So the notes are read again and again: a heartbeat that changes shows
/// that the run is running. If none does for so long, the run has died.
std::optional<RunState> look_at_run(const std::string& table,
                                    std::chrono::milliseconds patience = std::chrono::seconds(5));

}  // namespace sigmasweep
