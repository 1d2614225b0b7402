#include "studies/precision/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <vector>

#include "plot/named.hpp"
#include "plot/row_choice.hpp"
#include "sigmasweep/base/errors.hpp"
#include "studies/precision/plot.hpp"
#include "studies/precision/table.hpp"

namespace sigmasweep {
namespace {

/// The scenes that the plot chooses.
void draw(const Sweep& sweep, std::span<const PrecisionRow> rows, const PlotSpec& plot, const std::string& file) {
  RowChoice chosen(plot.where, parameter_fields());
  std::vector<PrecisionRow> drawn;
  std::ranges::copy_if(rows, std::back_inserter(drawn), [&](const PrecisionRow& each) {
    Row row;
    row.parameters = each.parameters;
    return chosen(row);
  });
  if (drawn.empty()) throw UsageError("plot: no scene satisfies 'where' in [plot]");
  plot_precision(drawn, sweep.axes(), plot.title.empty() ? sweep.title() : plot.title, file);
}

}  // namespace

void draw_precision(const Sweep& sweep, std::span<const PrecisionRow> rows, const std::string& file,
                    const std::string& name, std::FILE* out) {
  const auto& all = sweep.plots();
  const std::vector<PlotSpec> plots = name.empty() ? all : std::vector{plot_named(all, name)};
  for (const PlotSpec& plot : plots) {
    const bool is_main = plot.name == all.front().name || !name.empty();
    const std::string picture = is_main ? file : picture_named(file, plot.name);
    draw(sweep, rows, plot, picture);
    fmt::print(out, "{}\n", picture);
  }
}

void draw_stored_precision(const std::string& table, const std::string& file, const std::string& name) {
  PrecisionTable study = read_precision_table(table);
  const Sweep sweep = Sweep::parse_stored(study.spec_text, table);
  for (PrecisionRow& row : study.rows) {
    if (row.scene >= sweep.size()) throw IoError(fmt::format("{}: its rows are not those of its spec", table));
    const Integrator integrator = row.parameters.integrator;
    row.parameters = sweep.at(row.scene);
    row.parameters.integrator = integrator;
  }
  draw_precision(sweep, study.rows, file, name, stdout);
}

}  // namespace sigmasweep
