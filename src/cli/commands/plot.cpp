#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>

#include "base/output/place.hpp"
#include "cli/command.hpp"
#include "cli/read_sweep.hpp"
#include "cli/report/picture.hpp"
#include "engine/run_options.hpp"
#include "plot/named.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/stored/stored_sweep.hpp"
#include "studies/precision/pictures.hpp"
#include "studies/precision/plot.hpp"
#include "studies/precision/table.hpp"
#include "studies/sections.hpp"
#include "studies/stability/map.hpp"
#include "studies/stability/plot.hpp"

namespace sigmasweep {
namespace {

struct PlotOptions {
  std::string table, output;
  std::string spec;  ///< whose plots are drawn instead of those that the table has; empty: those
  std::string name;  ///< the plot to draw; empty: all
  std::string kind;  ///< "precision": error against run time; "stability": map of stable steps; empty: from the spec
  std::string x, y, x_scale, y_scale;  ///< if not empty, replace the spec's for one plot
  std::vector<std::string> series;
  bool quiet = false;  ///< do not print fits
};

bool has_overrides(const PlotOptions& o) {
  return !o.x.empty() || !o.y.empty() || !o.x_scale.empty() || !o.y_scale.empty() || !o.series.empty();
}

/// Replaces axes and series of the spec's plot by those of the command line. Fit and guides are dropped, because they
/// belong to the spec's axes.
void override(PlotSpec& spec, const PlotOptions& options) {
  if (!options.x.empty()) spec.x = options.x, spec.x_label.clear();
  if (!options.y.empty()) spec.y = options.y, spec.y_label.clear(), spec.y_error.clear();
  if (!options.x_scale.empty()) spec.x_log = options.x_scale == "log";
  if (!options.y_scale.empty()) spec.y_log = options.y_scale == "log";
  if (!options.series.empty()) spec.series = options.series;
  spec.kind = PlotKind::points;
  spec.fit.reset();
  spec.guides.clear();
}

/// Draws a plot of the table, prints the file's name and, unless `quiet`, the fits.
void draw(const StoredSweep& stored, const PlotSpec& spec, const PlotOptions& options, const std::string& file) {
  const std::string fits = draw_picture(stored, options.table, spec, file);
  fmt::print("{}\n", file);
  if (!options.quiet) fmt::print("{}", fits);
}

/// The plots of a spec, or those that the table was made with.
std::vector<PlotSpec> plots_of(const StoredSweep& stored, const std::string& spec) {
  if (!spec.empty()) return Sweep::load(spec, study_sections).plots();
  return stored.sweep ? stored.sweep->plots() : std::vector<PlotSpec>(1);
}

int plot_table(const PlotOptions& options) {
  const std::string own_name = std::filesystem::path(options.table).filename().string();
  const std::string main_file = options.output.empty() ? named_after(own_name, ".svg") : options.output;
  require_other_file(main_file, std::array{options.table});
  if (is_precision_table(options.table)) {
    if (!options.spec.empty()) throw UsageError("plot: --spec is for tables of 'run'");
    if (has_overrides(options)) throw UsageError("plot: a precision study has its own axes and series");
    draw_stored_precision(options.table, main_file, options.name);
    return 0;
  }
  const StoredSweep stored = read_sweep(options.table);
  if (stored.table.rows.empty()) throw InputNotFound(fmt::format("plot: {} has no row yet", options.table));
  const std::vector<PlotSpec> all = plots_of(stored, options.spec);
  if (options.kind == "precision") {
    plot_precision_of(stored.table.rows, stored.table.info.title, main_file);
    fmt::print("{}\n", main_file);
    return 0;
  }
  if (options.kind == "stability") {
    draw(stored, stability_plot(all), options, main_file);
    return 0;
  }
  std::vector<PlotSpec> plots = all;
  if (!options.name.empty()) plots = {plot_named(all, options.name)};
  if (has_overrides(options)) {
    plots.resize(1);
    override(plots[0], options);
  }
  for (const PlotSpec& spec : plots) {
    const bool has_main_file = spec.name == all[0].name || (!options.name.empty() && !options.output.empty());
    draw(stored, spec, options, has_main_file ? main_file : picture_named(main_file, spec.name));
  }
  return 0;
}

void declare(OptionSet& set, PlotOptions& options) {
  const auto add_scale = [&](const std::string& name, const std::string& axis, std::string& target) {
    set.add({name, fmt::format("Scale of the {} axis", axis), "linear|log", {"linear", "log"}}, target);
  };
  set.add({"table", "A table that 'run' or 'precision' wrote", "TABLE.h5"}, options.table);
  set.add({"-o,--output",
           "The picture of the first plot (further plots: FILE-name.svg); default: the table's name, in this directory",
           "FILE.svg|png|pdf|html|gp|csv"},
          options.output);
  set.add({"--spec", "Draw the plots of this spec instead; nothing is computed again", "SPEC.toml"}, options.spec);
  set.add({"--name", "Only the plot of this name", "NAME"}, options.name);
  set.add({"--kind",
           "Draw error bars against run times, or the stability of fixed time steps",
           "precision|stability",
           {"precision", "stability"}},
          options.kind);
  set.add({"--x", "Field of the x axis, or an expression", "FIELD"}, options.x);
  set.add({"--y", "Field of the y axis, or an expression", "FIELD"}, options.y);
  add_scale("--x-scale", "x", options.x_scale);
  add_scale("--y-scale", "y", options.y_scale);
  set.add({"--series", "Fields: one curve for each combination of their values", "FIELD,..."}, options.series,
          Several::comma_separated);
  set.add_flag("-q,--quiet", "Print names of files only, no fits", options.quiet);
}

}  // namespace

Command plot_command() {
  return make_command(
      "plot", "Draw a table as its spec says",
      "\nhtml is one page that works offline: zoom, and a point tells its row, its error and the command that repeats "
      "it;\n"
      "gp are the commands of gnuplot with their data, csv the points. Films and maps are svg, png or pdf.\n\n"
      "With --x, --y, --x-scale, --y-scale or --series only the first plot, or that of --name, is drawn, without\n"
      "the spec's fit and guides.\n\n"
      "  sigmasweep plot fig2a.h5 -o fig2a.png\n"
      "  sigmasweep plot fig2a.h5 -o fig2a.html\n"
      "  sigmasweep plot fig2a.h5 --x \"s0/v0\" --y \"1 - eps_eff\" --y-scale log -o loss.svg",
      declare, plot_table);
}

}  // namespace sigmasweep
