#include "cli/plot_films.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "engine/trajectories/trajectory_files.hpp"
#include "plot/films/lattice.hpp"
#include "plot/films/plot_velocity_field.hpp"
#include "plot/films/trajectories.hpp"
#include "plot/row_choice.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "store/h5md.hpp"

namespace sigmasweep {
namespace {

Trajectory read(const std::string& path, const Row& row, std::size_t samples) {
  Trajectory trajectory;
  try {
    trajectory = read_h5md(path);
  } catch (const InputNotFound& error) {
    throw InputNotFound(fmt::format("{}: 'sigmasweep run' with the same spec and table writes it", error.what()));
  }
  if (!is_h5md_of(path, row.parameters, samples, std::numeric_limits<double>::quiet_NaN()))
    throw IoError(fmt::format("{} is not the trajectory of row {} of this table", path, row.index));
  return trajectory;
}

}  // namespace

void plot_films(const StoredSweep& stored, const PlotSpec& spec, const std::string& table, const std::string& file) {
  const Sweep& sweep = stored.sweep.value();
  RowChoice chosen(spec.where);
  std::vector<Row> rows;
  for (const std::uint64_t k : sweep.trajectory()->rows) {
    const auto found = std::ranges::lower_bound(stored.table.rows, k, {}, &Row::index);
    if (found == stored.table.rows.end() || found->index != k) continue;  // of another slice, or not there yet
    const Row& row = *found;
    if (std::isfinite(show_time(row.parameters, row.result)) && chosen(row)) rows.push_back(row);
  }
  if (spec.mean_over.empty()) require_room_for(rows.size());
  std::vector<Panel> panels;
  for (const Row& row : rows)
    panels.push_back({row, read(trajectory_file(table, row.index), row, sweep.trajectory()->samples)});
  const std::string title = spec.title.empty() ? sweep.title() : spec.title;
  const auto planes = std::ranges::count_if(panels, &Trajectory::is_plane, &Panel::trajectory);
  if (planes == std::ssize(panels) && spec.by_phase)
    return plot_velocity_fields(panels, sweep.axes(), spec.mean_over, title, file);
  if (!spec.mean_over.empty())
    throw UsageError(
        "plot: only velocity fields by phase can be averaged: 'mean_over' needs geometry = 'vibrated-lattice' and "
        "x = 'phase'");
  if (planes == std::ssize(panels)) return plot_lattices(panels, sweep.axes(), title, file);
  if (planes > 0)
    throw UsageError(
        "plot: trajectories of columns and of lattices cannot be drawn on one picture: choose rows with 'where' in "
        "[plot]");
  const std::uint64_t columns = sweep.axes().empty() ? 1 : sweep.axis_sizes().back();
  plot_trajectories(panels, columns, sweep.axes(), title, file, spec.by_phase);
}

}  // namespace sigmasweep
