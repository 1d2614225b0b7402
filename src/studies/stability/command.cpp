#include "studies/stability/command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/exit_codes.hpp"
#include "base/standard_error.hpp"
#include "mpi/on_root.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/stored/stored_sweep.hpp"
#include "studies/stability/map.hpp"
#include "studies/stability/plot.hpp"
#include "studies/stability/text.hpp"

namespace sigmasweep {
namespace {

using namespace exit_code;

void require_steps(const Sweep& sweep, const std::string& spec) {
  const auto& columns = sweep.columns();
  const auto has = [&](std::string_view name) {
    return std::ranges::find(columns, name, &Field::name) != columns.end();
  };
  if (!has("predicted_growth"))
    throw SpecError(fmt::format("{}: a stability study needs tuples with {}", spec,
                                requirement_of(*find_field("predicted_growth"))));
}

bool is_well(const Row& row) { return row.result.status == Status::unstable || is_success(row.result.status); }

}  // namespace

int stability_study(World& world, const StabilityOptions& options) {
  const int loaded = run_on_root(world, [&] {
    require_steps(Sweep::load(options.run.spec, options.run.sections, options.run.settings), options.run.spec);
    return success;
  });
  if (loaded != success) return loaded;
  const int ran = run(world, options.run);
  if (ran != success && ran != some_rows_failed) return ran;
  return run_on_root(world, [&] {
    const std::string table = options.run.output.empty() ? default_table(options.run.spec) : options.run.output;
    const StoredSweep stored = read_finished_sweep(table);
    const auto& rows = stored.table.rows;
    const PlotSpec map = stability_plot(stored.sweep->plots());
    fmt::print("{}", stability_text(rows, map, stored.sweep->axes()));
    for (const char* form : {".svg", ".png"}) {
      if (!options.plots) break;
      const std::string picture = named_after(table, form);
      plot_stability(rows, map, stored.sweep->axes(), stored.table.info.title, picture);
      print_on_stderr(picture + "\n");
    }
    return std::ranges::all_of(rows, is_well) ? success : some_rows_failed;
  });
}

}  // namespace sigmasweep
