#include "engine/phases/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/exit_codes.hpp"
#include "engine/report/summary.hpp"
#include "mpi/on_root.hpp"

namespace sigmasweep {

int report_rows(const World& world, const OpenSweep& open, const Computed& computed, const Reporter& reporter) {
  return run_on_root(world, [&] {
    const auto& rows = open.manager_rows();
    reporter.show(fmt::format("{}: {}", open.table, summary(rows, computed.work, world.size(), computed.wall_seconds)));
    const bool fine = std::ranges::all_of(rows, [](const Row& row) { return is_success(row.result.status); });
    return fine ? exit_code::success : exit_code::some_rows_failed;
  });
}

}  // namespace sigmasweep
