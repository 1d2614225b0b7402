#include "engine/phases/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "base/exit_codes.hpp"
#include "engine/report/summary.hpp"
#include "engine/report/summary_json.hpp"
#include "mpi/on_root.hpp"

namespace sigmasweep {

namespace {

int exit_code_of(const std::vector<Row>& rows) {
  const bool fine = std::ranges::all_of(rows, [](const Row& row) { return is_success(row.result.status); });
  return fine ? exit_code::success : exit_code::some_rows_failed;
}

}  // namespace

int report_rows(const World& world, const OpenSweep& open, const Computed& computed, const Reporter& reporter) {
  return run_on_root(world, [&] {
    const auto& rows = open.manager_rows();
    reporter.show(fmt::format("{}: {}", open.table, summary(rows, computed.work, world.size(), computed.wall_seconds)));
    return exit_code_of(rows);
  });
}

int report_as_json(const World& world, const OpenSweep& open, const Computed& computed, bool finished,
                   const Reporter& reporter) {
  return run_on_root(world, [&] {
    const auto& rows = open.manager_rows();
    std::vector<Row> some;
    if (!open.ledger->is_complete())
      std::ranges::copy_if(rows, std::back_inserter(some), [&](const Row& row) { return open.ledger->has(row.index); });
    const RunEnd end{.table = open.table,
                     .exit_code = finished ? exit_code_of(rows) : exit_code::stopped,
                     .total = rows.size(),
                     .work = computed.work,
                     .ranks = world.size(),
                     .wall_seconds = computed.wall_seconds};
    reporter.document(summary_json(open.ledger->is_complete() ? rows : some, end));
    return end.exit_code;
  });
}

}  // namespace sigmasweep
