#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "store/stored/stored_rows.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// The rows of a sweep, complete or not, with the sweep that they came from.
struct StoredSweep : StoredRows {
  /// Not there if this program cannot read the table's spec any more, or reads it otherwise.
  std::optional<Sweep> sweep{};
};

/// Reads what is there of a sweep: its table, or its journal while it is not complete. Parameters that are no columns
/// are filled in from the spec. Throws as read_stored_rows().
StoredSweep read_stored_sweep(const std::string& path);
/// The same for its table alone, whatever journal stands beside it. Throws as read_table().
StoredSweep read_finished_sweep(const std::string& path);

/// "beads.h5 is not complete: 71 of 800 rows so far"; empty if it is complete.
std::string incomplete_line(const StoredRows& stored, const std::string& path);

/// Whether the rows have the axes' values that the sweep has for them. A program of another version may have read its
/// spec otherwise, as those did whose Sobol samples began with the second point.
bool has_axes_of(const Sweep& sweep, std::span<const Row> rows);

/// Why the rows of the table must not be mixed with rows of this program ("was computed by another ..."); empty if they
/// may.
std::string why_not_ours(const StoredSweep& stored);
/// The same for one reason alone: other physics; another build, which may have other last digits.
std::string why_other_physics(const TableInfo& info);
std::string why_other_build(const TableInfo& info);

/// How many rows have each status, of those that occur, in the order of their numbers.
std::vector<std::pair<std::string_view, std::uint64_t>> count_by_status(std::span<const Row> rows);
/// "ok 2005, time_limit 5".
std::string rows_by_status(std::span<const Row> rows);

}  // namespace sigmasweep
