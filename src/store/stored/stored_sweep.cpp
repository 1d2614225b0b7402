#include "store/stored/stored_sweep.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/exact_number.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "store/build_info.hpp"

namespace sigmasweep {

namespace {

/// Gives the rows of journals the parameters that the spec has for them. Rows that had others, of a program with other
/// defaults, are left out.
void take_parameters_of_spec(StoredSweep& stored) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < stored.table.rows.size(); ++k) {
    Row row = stored.table.rows[k];
    row.parameters = stored.sweep->at(row.index);
    if (content_key(row.parameters) == stored.content_keys[k]) stored.table.rows[kept++] = row;
  }
  stored.table.rows.resize(kept);
  stored.content_keys.clear();
}

/// Adds the sweep to the rows, and to each row the parameters that it has from the spec.
StoredSweep with_sweep(StoredRows rows_of_it, const std::string& path) {
  StoredSweep stored{std::move(rows_of_it), std::nullopt};
  const TableInfo& info = stored.table.info;
  if (stored.total == 0) throw IoError(fmt::format("{}: it has no rows", path));
  try {
    stored.sweep = Sweep::parse_stored(info.spec_text, path);
  } catch (const SpecError&) {  // of another version: the table itself is still good
    if (!stored.complete) throw IoError(fmt::format("{}.journal has a spec that this program cannot read", path));
    return stored;
  }
  if (stored.sweep->hash() != info.spec_hash)
    throw IoError(fmt::format("{}: its spec is not the one that it was made from", path));
  if (info.slice.size(stored.sweep->size()) != stored.total)
    throw IoError(fmt::format("{}: its rows are not those of its spec", path));
  auto& rows = stored.table.rows;
  if (!stored.complete) {
    stored.table.columns = stored.sweep->columns();
    take_parameters_of_spec(stored);
    return stored;
  }
  if (!has_axes_of(*stored.sweep, rows)) {
    stored.sweep.reset();
    return stored;
  }
  for (Row& row : rows) row.parameters = stored.sweep->at(row.index);
  return stored;
}

}  // namespace

StoredSweep read_stored_sweep(const std::string& path) { return with_sweep(read_stored_rows(path), path); }

StoredSweep read_finished_sweep(const std::string& path) {
  StoredRows stored;
  stored.table = read_table(path);
  stored.total = stored.table.rows.size();
  return with_sweep(std::move(stored), path);
}

std::string incomplete_line(const StoredRows& stored, const std::string& path) {
  if (stored.complete) return {};
  return fmt::format("{} is not complete: {} of {} rows so far", path, stored.table.rows.size(), stored.total);
}

bool has_axes_of(const Sweep& sweep, std::span<const Row> rows) {
  std::vector<const ParameterField*> axes;
  for (const std::string& name : sweep.axes()) axes.push_back(find_parameter(name));
  return std::ranges::all_of(rows, [&](const Row& row) {
    const Parameters of_spec = sweep.at(row.index);
    return std::ranges::all_of(axes, [&](const ParameterField* axis) {
      return exact_number(*axis, row.parameters) == exact_number(*axis, of_spec);
    });
  });
}

std::string why_not_ours(const StoredSweep& stored) {
  if (!stored.sweep) return "has a spec that this program cannot read, or reads otherwise";
  const std::string physics = why_other_physics(stored.table.info);
  return physics.empty() ? why_other_build(stored.table.info) : physics;
}

std::string why_other_physics(const TableInfo& info) {
  if (info.physics_version == physics_version) return {};
  return fmt::format("was computed with physics version {}, this program has {}", info.physics_version,
                     physics_version);
}

std::string why_other_build(const TableInfo& info) {
  if (info.build == build_name()) return {};
  return "was computed by another build of the program, whose last digits may differ";
}

std::vector<std::pair<std::string_view, std::uint64_t>> count_by_status(std::span<const Row> rows) {
  const auto names = names_of<Status>();
  std::vector<std::pair<std::string_view, std::uint64_t>> counts;
  for (const std::string_view name : names) counts.emplace_back(name, 0);
  for (const Row& row : rows) ++counts.at(static_cast<std::size_t>(row.result.status)).second;
  std::erase_if(counts, [](const auto& count) { return count.second == 0; });
  return counts;
}

std::string rows_by_status(std::span<const Row> rows) {
  std::string text;
  for (const auto& [name, count] : count_by_status(rows))
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text;
}

}  // namespace sigmasweep
