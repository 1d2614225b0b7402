#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

#include "commands.hpp"
#include "plot_films.hpp"
#include "sigmasweep/errors.hpp"
#include "sigmasweep/report/plot.hpp"
#include "sigmasweep/report/precision.hpp"
#include "sigmasweep/sweep/spelling.hpp"
#include "stored_sweep.hpp"

namespace sigmasweep {
namespace {

const PlotSpec& plot_named(const std::vector<PlotSpec>& plots, const std::string& name) {
  if (const auto found = std::ranges::find(plots, name, &PlotSpec::name); found != plots.end()) return *found;
  std::vector<std::string_view> known;
  for (const PlotSpec& plot : plots)
    if (!plot.name.empty()) known.push_back(plot.name);
  throw UsageError(fmt::format("the table's spec has no plot '{}'{}", name,
                               known.empty() ? "; none has a name" : hint(name, known)));
}

bool has_overrides(const PlotOptions& o) {
  return !o.x.empty() || !o.y.empty() || !o.x_scale.empty() || !o.y_scale.empty() || !o.series.empty();
}

/// The spec's plot with what the command line has instead. Fit and guides belong to the spec's axes.
void override(PlotSpec& spec, const PlotOptions& options) {
  if (!options.x.empty()) spec.x = options.x, spec.x_label.clear();
  if (!options.y.empty()) spec.y = options.y, spec.y_label.clear();
  if (!options.x_scale.empty()) spec.x_log = options.x_scale == "log";
  if (!options.y_scale.empty()) spec.y_log = options.y_scale == "log";
  if (!options.series.empty()) spec.series = options.series;
  spec.kind = PlotKind::points;
  spec.fit.reset();
  spec.guides.clear();
}

std::string with_name(const std::filesystem::path& file, const std::string& name) {
  const std::string stem = file.stem().string() + "-" + name;
  return (file.parent_path() / (stem + file.extension().string())).string();
}

}  // namespace

int plot(const PlotOptions& options) {
  const StoredSweep stored = read_stored_sweep(options.table);
  const std::vector<PlotSpec> all = stored.sweep ? stored.sweep->plots() : std::vector<PlotSpec>(1);
  std::vector<PlotSpec> plots = all;
  if (!options.name.empty()) plots = {plot_named(all, options.name)};
  if (has_overrides(options)) {
    plots.resize(1);
    override(plots[0], options);
  }
  const std::filesystem::path table(options.table);
  const std::string main_file =
      options.output.empty() ? table.filename().replace_extension(".svg").string() : options.output;
  if (options.kind == "precision") {
    plot_precision_of(stored.table.rows, stored.table.info.title, main_file);
    fmt::print("{}\n", main_file);
    return 0;
  }
  for (const PlotSpec& spec : plots) {
    const bool has_main_file =
        spec.name == all[0].name || (!options.name.empty() && !options.output.empty());
    const std::string file = has_main_file ? main_file : with_name(main_file, spec.name);
    if (spec.kind == PlotKind::trajectories) {
      plot_films(stored, spec, options.table, file);
      fmt::print("{}\n", file);
      continue;
    }
    const auto fits = plot_rows(stored.table.rows, spec, stored.table.info.title, file);
    fmt::print("{}\n", file);
    if (spec.fit && !options.quiet) fmt::print("{}", fit_table(fits, *spec.fit));
  }
  return 0;
}

}  // namespace sigmasweep
