#pragma once

#include <cstdint>
#include <string>

#include "engine/report/summary.hpp"

namespace sigmasweep {

/// What a run came to, beside its rows.
struct RunEnd {
  std::string table;        ///< path
  int exit_code = 0;        ///< of the run
  std::uint64_t total = 0;  ///< rows that the finished table has
  Work work{};              ///< computed by this run
  int ranks = 1;
  double wall_seconds = 0.0;  ///< that the computing of `work` took
};

/// The summary() as a JSON document. The names are those of `sigmasweep status --json` where they mean the same. `rows`
/// are the rows that are there, `seen` is their overview().
std::string summary_json(const RowSource& rows, const Overview& seen, const RunEnd& end);

}  // namespace sigmasweep
