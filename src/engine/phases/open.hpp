#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/ledger/ledger.hpp"
#include "engine/report/reporter.hpp"
#include "engine/report/row_source.hpp"
#include "engine/run_options.hpp"
#include "mpi/world.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/slice.hpp"

namespace sigmasweep {

/// A sweep that is opened for a run, on each rank.
struct OpenSweep {
  Sweep sweep;
  std::string table;  ///< path
  Slice slice;
  bool fresh = false, retry = false;                     ///< as of RunOptions
  std::string start;                                     ///< when the run began: ISO 8601, UTC
  std::chrono::steady_clock::time_point steady_start{};  ///< the same moment
  std::optional<Ledger> ledger{};                        ///< on the manager
  Attempts attempts{};                                   ///< as Ledger::attempts(), on each rank
  bool table_is_complete = false;                        ///< the table has all rows already

  std::uint64_t rows() const { return slice.size(sweep.size()); }  ///< to be in the table
  /// The rows of the table, once it is there.
  RowSource table_rows() const;
  /// What a journal that is made says of this run.
  TableInfo info(const World& world) const;
  /// How to go on with a run that was stopped.
  const char* restart_hint() const { return fresh ? "run it again without --fresh" : "run it again"; }
};

/// First phase: reads the spec and looks at the rows that are there already. Throws as Sweep::load() and Ledger do.
OpenSweep open_sweep(const World& world, const RunOptions& options, const Reporter& reporter);

}  // namespace sigmasweep
