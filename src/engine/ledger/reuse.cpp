#include "engine/ledger/reuse.hpp"

#include <unordered_map>
#include <utility>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

namespace {

using KnownRows = std::unordered_map<std::uint64_t, const Row*>;  ///< by content key

std::vector<Row> rows_among(const KnownRows& known, const Sweep& sweep, const Slice& slice) {
  std::vector<Row> rows;
  for (std::uint64_t k = 0; k < slice.size(sweep.size()); ++k) {
    Row row;
    row.index = slice.row(k);
    row.parameters = sweep.at(row.index);
    const auto found = known.find(content_key(row.parameters));
    if (found == known.end()) continue;
    row.result = found->second->result;
    row.timing = found->second->timing;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<Row> rows_among(std::span<const Row> old, const Sweep& sweep, const Slice& slice) {
  KnownRows known;
  known.reserve(old.size());
  for (const Row& row : old)
    if (is_reproducible(row.result.status)) known.emplace(content_key(row.parameters), &row);
  return rows_among(known, sweep, slice);
}

std::vector<Row> rows_among(std::span<const JournalledRow> old, const Sweep& sweep, const Slice& slice) {
  KnownRows known;
  known.reserve(old.size());
  for (const auto& [row, key] : old)
    if (is_reproducible(row.result.status)) known.emplace(key, &row);
  return rows_among(known, sweep, slice);
}

bool has_same_tuples(const Sweep& sweep, const Slice& slice, const TableInfo& theirs) {
  try {
    const Sweep old = Sweep::parse_stored(theirs.spec_text, "the journal's spec");
    if (old.size() != sweep.size() || theirs.slice != slice) return false;
    for (std::uint64_t k = 0; k < slice.size(sweep.size()); ++k)
      if (content_key(old.at(slice.row(k))) != content_key(sweep.at(slice.row(k)))) return false;
    return true;
  } catch (const SpecError&) {  // of another version
    return false;
  }
}

ReusableRows reusable_rows(const std::string& path) {
  StoredSweep stored = read_finished_sweep(path);
  std::string why_not = why_not_ours(stored);
  if (!why_not.empty()) return {{}, std::move(why_not)};
  return {std::move(stored.table.rows), {}};
}

}  // namespace sigmasweep
