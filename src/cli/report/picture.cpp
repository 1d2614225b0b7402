#include "cli/report/picture.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/films/plot.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/plot/plot.hpp"
#include "studies/stability/plot.hpp"

namespace sigmasweep {
namespace {

/// The title, which says when rows are still to come.
std::string title_of(const StoredSweep& stored, const PlotSpec& spec) {
  std::string title = spec.title.empty() ? stored.table.info.title : spec.title;
  if (stored.complete) return title;
  return fmt::format("{}{}({} of {} rows so far)", title, title.empty() ? "" : " ", stored.table.rows.size(),
                     stored.total);
}

}  // namespace

std::string draw_picture(const StoredSweep& stored, const std::string& table, PlotSpec spec, const std::string& file) {
  const auto& [info, columns, rows] = stored.table;
  spec.title = title_of(stored, spec);
  std::vector<SeriesFit> fits;
  switch (spec.kind) {
    case PlotKind::points: fits = plot_rows(rows, spec, info.title, file); break;
    case PlotKind::trajectories: plot_films(stored, spec, table, file); break;
    case PlotKind::stability:
      if (!stored.sweep)
        throw UsageError("plot: the table's spec, which names the map's axes, cannot be read any more");
      plot_stability(rows, spec, stored.sweep->axes(), info.title, file);
  }
  return spec.fit ? fit_table(fits, *spec.fit) : "";
}

}  // namespace sigmasweep
