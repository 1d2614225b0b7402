#include "engine/phases/report.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/exit_codes.hpp"
#include "engine/report/summary.hpp"
#include "engine/report/summary_json.hpp"
#include "mpi/on_root.hpp"

namespace sigmasweep {

namespace {

int exit_code_of(const RowSource& rows) {
  for (std::uint64_t k = 0; k < rows.size(); ++k)
    if (!is_success(rows[k].result.status)) return exit_code::some_rows_failed;
  return exit_code::success;
}

/// The rows that are there.
RowSource done(const OpenSweep& open) {
  const Ledger& ledger = *open.ledger;
  if (ledger.is_complete()) return open.manager_rows();
  std::vector<std::uint64_t> places;
  for (std::uint64_t place = 0; place < ledger.packed().size(); ++place)
    if (ledger.has(open.slice.row(place))) places.push_back(place);
  const std::uint64_t count = places.size();
  return {count, [&ledger, places = std::move(places)](std::uint64_t k) { return ledger.row(places[k]); }};
}

}  // namespace

int report_rows(const World& world, const OpenSweep& open, const Computed& computed, const Reporter& reporter) {
  return run_on_root(world, [&] {
    const RowSource rows = open.manager_rows();
    reporter.show(fmt::format("{}: {}", open.table, summary(rows, computed.work, world.size(), computed.wall_seconds)));
    return exit_code_of(rows);
  });
}

int report_as_json(const World& world, const OpenSweep& open, const Computed& computed, bool finished,
                   const Reporter& reporter) {
  return run_on_root(world, [&] {
    const RowSource rows = open.manager_rows();
    const RunEnd end{.table = open.table,
                     .exit_code = finished ? exit_code_of(rows) : exit_code::stopped,
                     .total = rows.size(),
                     .work = computed.work,
                     .ranks = world.size(),
                     .wall_seconds = computed.wall_seconds};
    reporter.document(summary_json(done(open), end));
    return end.exit_code;
  });
}

}  // namespace sigmasweep
