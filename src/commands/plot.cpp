#include <fmt/format.h>
#include <filesystem>

#include "commands.hpp"
#include "sigmasweep/report/plot.hpp"
#include "stored_sweep.hpp"

namespace sigmasweep {

int plot(const PlotOptions& options) {
  const StoredSweep stored = read_stored_sweep(options.table);
  PlotSpec spec = stored.sweep ? stored.sweep->plot() : PlotSpec{};
  if (!options.x.empty()) spec.x = options.x;
  if (!options.y.empty()) spec.y = options.y;
  if (!options.x_scale.empty()) spec.x_log = options.x_scale == "log";
  if (!options.y_scale.empty()) spec.y_log = options.y_scale == "log";
  if (!options.series.empty()) spec.series = options.series;
  const std::string output = options.output.empty()
                                 ? std::filesystem::path(options.table).filename().replace_extension(".svg").string()
                                 : options.output;
  plot_rows(stored.table.rows, spec, stored.table.info.title, output);
  fmt::print("{}\n", output);
  return 0;
}

}  // namespace sigmasweep
