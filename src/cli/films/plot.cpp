#include "cli/films/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

#include "cli/films/read.hpp"
#include "plot/films/lattice.hpp"
#include "plot/films/plot_velocity_field.hpp"
#include "plot/films/trajectories.hpp"
#include "plot/row_choice.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

void plot_films(const StoredSweep& stored, const PlotSpec& spec, const std::string& table, const std::string& file) {
  const Sweep& sweep = stored.sweep.value();
  RowChoice chosen(spec.where);
  std::vector<Row> rows;
  std::ranges::copy_if(filmed_rows(stored), std::back_inserter(rows), std::ref(chosen));
  if (spec.mean_over.empty()) require_room_for(rows.size());
  std::vector<Panel> panels;
  for (const Row& row : rows) panels.push_back({row, read_film(stored, table, row)});
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
