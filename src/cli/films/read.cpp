#include "cli/films/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/trajectories/trajectory_files.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "store/h5md.hpp"

namespace sigmasweep {

std::vector<Row> filmed_rows(const StoredSweep& stored) {
  std::vector<Row> rows;
  for (const std::uint64_t k : stored.sweep.value().trajectory()->rows) {
    const auto found = std::ranges::lower_bound(stored.table.rows, k, {}, &Row::index);
    if (found == stored.table.rows.end() || found->index != k) continue;  // of another slice, or not there yet
    if (std::isfinite(show_time(found->parameters, found->result))) rows.push_back(*found);
  }
  return rows;
}

Trajectory read_film(const StoredSweep& stored, const std::string& table, const Row& row) {
  const std::string path = trajectory_file(table, row.index);
  Trajectory trajectory;
  try {
    trajectory = read_h5md(path);
  } catch (const InputNotFound& error) {
    throw InputNotFound(fmt::format("{}: 'sigmasweep run' with the same spec and table writes it", error.what()));
  }
  const std::size_t samples = stored.sweep.value().trajectory()->samples;
  if (!is_h5md_of(path, row.parameters, samples, std::numeric_limits<double>::quiet_NaN()))
    throw IoError(fmt::format("{} is not the trajectory of row {} of this table", path, row.index));
  return trajectory;
}

}  // namespace sigmasweep
