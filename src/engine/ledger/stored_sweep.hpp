#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "store/table/table.hpp"

namespace sigmasweep {

/// A table with the sweep that it came from.
struct StoredSweep {
  Table table;
  std::optional<Sweep> sweep;  ///< not there if this program cannot read the table's spec any more
};

/// Reads a table. Parameters that are no columns are filled in from its spec. Throws as read_table().
StoredSweep read_stored_sweep(const std::string& path);

/// Why the rows of the table must not be mixed with rows of this program ("was computed by another ..."); empty if they
/// may.
std::string why_not_ours(const StoredSweep& stored);
/// The same for one reason alone: other physics; another build, which may have other last digits.
std::string why_other_physics(const TableInfo& info);
std::string why_other_build(const TableInfo& info);

/// "ok 2005, time_limit 5".
std::string rows_by_status(std::span<const Row> rows);

/// The command line that computes this row again, to the bit.
std::string repeat_command(const Row& row);

}  // namespace sigmasweep
