#pragma once

#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/journal/record.hpp"
#include "store/table/table_info.hpp"
#include "sweep/slice.hpp"

namespace sigmasweep {

/// Those rows of `slice` of the sweep that are among `old` at any place: the same tuple by content_key().
std::vector<Row> rows_among(std::span<const Row> old, const Sweep& sweep, const Slice& slice);
std::vector<Row> rows_among(std::span<const JournalledRow> old, const Sweep& sweep, const Slice& slice);

/// Whether the sweep that `theirs` describes has the same tuples in the same order as this slice of the sweep: then
/// only comments, plots and the like of its spec were edited.
bool has_same_tuples(const Sweep& sweep, const Slice& slice, const TableInfo& theirs);

/// Rows of a table that may be taken over.
struct ReusableRows {
  std::vector<Row> rows;
  std::string why_not;  ///< why there are none: of other physics, of another build, ...
};
/// Throws as read_table().
ReusableRows reusable_rows(const std::string& table);

}  // namespace sigmasweep
