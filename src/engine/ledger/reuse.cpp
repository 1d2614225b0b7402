#include "engine/ledger/reuse.hpp"

#include <unordered_map>
#include <utility>

#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

std::vector<Row> rows_among(std::span<const Row> old, const Sweep& sweep, const Slice& slice) {
  std::unordered_map<std::uint64_t, const Row*> known;
  known.reserve(old.size());
  for (const Row& row : old)
    if (is_reproducible(row.result.status)) known.emplace(content_key(row.parameters), &row);
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

ReusableRows reusable_rows(const std::string& path) {
  StoredSweep stored = read_finished_sweep(path);
  std::string why_not = why_not_ours(stored);
  if (!why_not.empty()) return {{}, std::move(why_not)};
  return {std::move(stored.table.rows), {}};
}

}  // namespace sigmasweep
