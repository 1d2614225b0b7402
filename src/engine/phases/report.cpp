#include "engine/phases/report.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "base/exit_codes.hpp"
#include "engine/report/summary.hpp"
#include "engine/report/summary_json.hpp"
#include "mpi/on_root.hpp"

namespace sigmasweep {

namespace {

int exit_code_of(const Overview& seen) { return seen.failed > 0 ? exit_code::some_rows_failed : exit_code::success; }

/// The rows that are there.
RowSource done(const OpenSweep& open, bool table_is_there) {
  if (table_is_there) return open.table_rows();
  auto rows = std::make_shared<std::vector<Row>>(open.ledger->journalled());
  const std::uint64_t count = rows->size();
  return {count, [rows = std::move(rows)](std::uint64_t k) { return (*rows)[k]; }};
}

}  // namespace

int report_rows(const World& world, const OpenSweep& open, const Computed& computed, const Reporter& reporter) {
  return run_on_root(world, [&] {
    const RowSource rows = open.table_rows();
    const Overview seen = overview(rows);
    reporter.show(
        fmt::format("{}: {}", open.table, summary(rows, seen, computed.work, world.size(), computed.wall_seconds)));
    return exit_code_of(seen);
  });
}

int report_as_json(const World& world, const OpenSweep& open, const Computed& computed, bool finished,
                   const Reporter& reporter) {
  return run_on_root(world, [&] {
    const RowSource rows = done(open, open.table_is_complete || computed.is_complete);
    const Overview seen = overview(rows);
    const RunEnd end{.table = open.table,
                     .exit_code = finished ? exit_code_of(seen) : exit_code::stopped,
                     .total = open.rows(),
                     .work = computed.work,
                     .ranks = world.size(),
                     .wall_seconds = computed.wall_seconds};
    reporter.document(summary_json(rows, seen, end));
    return end.exit_code;
  });
}

}  // namespace sigmasweep
