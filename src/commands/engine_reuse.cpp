#include "engine_reuse.hpp"

#include <fmt/format.h>

#include <unordered_map>
#include <utility>

#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/store/build_info.hpp"
#include "stored_sweep.hpp"

namespace sigmasweep {

std::vector<Row> rows_among(std::span<const Row> old, const Sweep& sweep, const Slice& slice) {
  std::unordered_map<std::uint64_t, const Row*> known;
  known.reserve(old.size());
  for (const Row& row : old)
    if (is_reproducible(row.collision.status)) known.emplace(content_key(row.parameters), &row);
  std::vector<Row> rows;
  for (std::uint64_t k = 0; k < slice.size(sweep.size()); ++k) {
    Row row;
    row.index = slice.row(k);
    row.parameters = sweep.at(row.index);
    const auto found = known.find(content_key(row.parameters));
    if (found == known.end()) continue;
    row.collision = found->second->collision;
    row.timing = found->second->timing;
    rows.push_back(row);
  }
  return rows;
}

ReusableRows reusable_rows(const std::string& path) {
  StoredSweep stored = read_stored_sweep(path);
  const TableInfo& info = stored.table.info;
  if (info.physics_version != physics_version)
    return {{}, fmt::format("was computed with physics version {}, this program has {}", info.physics_version,
                            physics_version)};
  if (info.build != build_name())
    return {{}, "was computed by another build of the program, whose last digits may differ"};
  if (!stored.sweep) return {{}, "has a spec that this program cannot read"};
  return {std::move(stored.table.rows), {}};
}

}  // namespace sigmasweep
