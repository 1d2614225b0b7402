#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands.hpp"
#include "exit_codes.hpp"
#include "on_manager.hpp"
#include "sigmasweep/errors.hpp"
#include "sigmasweep/report/stability.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "stored_sweep.hpp"

namespace sigmasweep {
namespace {

using namespace exit_code;

void require_steps(const Sweep& sweep, const std::string& spec) {
  const auto& columns = sweep.columns();
  if (std::ranges::find(columns, "predicted_growth", &Field::name) == columns.end())
    throw SpecError(fmt::format("{}: a stability study needs tuples with integrator gear5, verlet or rk4", spec));
}

/// The table's first map, as the spec says or with the defaults.
PlotSpec map_of(const Sweep& sweep) {
  const auto& plots = sweep.plots();
  const auto found = std::ranges::find(plots, PlotKind::stability, &PlotSpec::kind);
  return found != plots.end() ? *found : PlotSpec{};
}

bool is_well(const Row& row) { return row.collision.status == Status::unstable || is_success(row.collision.status); }

}  // namespace

int stability(World& world, const StabilityOptions& options) {
  const int loaded = on_manager(world, [&] {
    require_steps(Sweep::load(options.run.spec), options.run.spec);
    return success;
  });
  if (loaded != success) return loaded;
  const int ran = run(world, options.run);
  if (ran != success && ran != some_rows_failed) return ran;
  return on_manager(world, [&] {
    const std::string table = options.run.output.empty() ? default_table(options.run.spec) : options.run.output;
    const StoredSweep stored = read_stored_sweep(table);
    const auto& rows = stored.table.rows;
    const PlotSpec map = map_of(*stored.sweep);
    fmt::print("{}", stability_text(rows, map, stored.sweep->axes()));
    for (const char* form : {".svg", ".png"}) {
      if (!options.plots) break;
      const std::string picture = std::filesystem::path(table).replace_extension(form).string();
      plot_stability(rows, map, stored.sweep->axes(), stored.table.info.title, picture);
      fmt::print(stderr, "{}\n", picture);
    }
    return std::ranges::all_of(rows, is_well) ? success : some_rows_failed;
  });
}

}  // namespace sigmasweep
