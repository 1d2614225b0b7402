#include "engine/phases/open.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <span>
#include <utility>

#include "engine/distribute/wire.hpp"
#include "engine/phases/phase.hpp"
#include "engine/report/provenance.hpp"
#include "engine/trajectories/trajectories.hpp"
#include "store/table/packed_rows.hpp"
#include "store/table/place.hpp"
#include "store/table/read.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t most_rows_in_memory = std::uint64_t{1} << 22;  // in which rows are looked up in any order

/// The manager's attempts on every rank. Collective.
Attempts broadcast(const World& world, const Attempts& attempts) {
  wire::Bytes bytes;
  for (const auto& [row, attempt] : attempts) {
    wire::append(bytes, row);
    wire::append(bytes, attempt);
  }
  const std::string text = world.broadcast(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  Attempts received;
  for (auto left = std::as_bytes(std::span(text)); !left.empty();) {
    std::uint64_t row = 0;
    wire::take(left, row);
    wire::take(left, received[row]);
  }
  return received;
}

void report_kept_rows(const Ledger& ledger, const std::string& table, std::uint64_t rows, const Reporter& reporter) {
  for (const std::string& remark : ledger.remarks()) reporter.say(remark);
  if (ledger.table_is_complete())
    reporter.say(fmt::format("{} is complete, nothing to compute (--fresh starts again)", table));
  else if (ledger.kept() > 0)
    reporter.say(fmt::format("going on with {} of {} rows{}", ledger.kept(), rows,
                             ledger.taken() ? fmt::format(", {} of them taken over", ledger.taken()) : ""));
}

}  // namespace

RowSource OpenSweep::table_rows() const {
  auto rows = std::make_shared<TableRows>(table);
  const std::uint64_t size = rows->size();
  if (size <= most_rows_in_memory) {  // any order is fast then
    auto packed = std::make_shared<PackedRows>(sweep.columns(), size);
    for (std::uint64_t place = 0; place < size; ++place) packed->set(place, (*rows)[place]);
    return {size, [this, packed = std::move(packed)](std::uint64_t place) {
              Row row{.index = slice.row(place), .parameters = {}, .result = {}, .timing = {}};
              packed->get(place, row);
              row.parameters = sweep.at(row.index);
              return row;
            }};
  }
  return {size, [this, rows = std::move(rows)](std::uint64_t place) {
            Row row = (*rows)[place];
            row.parameters = sweep.at(row.index);
            return row;
          }};
}

TableInfo OpenSweep::info(const World& world) const {
  TableInfo info = table_info(sweep, start, world.size());
  info.slice = slice;
  return info;
}

OpenSweep open_sweep(const World& world, const RunOptions& options, const Reporter& reporter) {
  const auto steady_start = std::chrono::steady_clock::now();
  std::string start = utc_now();
  const std::string table = options.output.empty() ? default_table(options.spec) : options.output;
  std::optional<Sweep> sweep;
  std::optional<Ledger> ledger;
  on_manager(world, [&] {
    if (options.output.empty()) require_named_spec(options.spec);
    sweep = Sweep::load(options.spec, options.sections, options.settings);
    require_place_for_table(table, std::array{options.spec});
    require_own_trajectories(*sweep, table, options.fresh);
    TableInfo info = table_info(*sweep, start, world.size());
    info.slice = options.slice;
    ledger.emplace(*sweep, table,
                   LedgerOptions{.fresh = options.fresh,
                                 .slice = options.slice,
                                 .extend = options.extend,
                                 .reuse = options.reuse,
                                 .retry = options.retry,
                                 .info = std::move(info)});
    if (options.fresh) remove_trajectories(*sweep, table);
    report_kept_rows(*ledger, table, options.slice.size(sweep->size()), reporter);
  });
  const std::string text = world.broadcast(sweep ? sweep->text() : "");
  if (!sweep) sweep = Sweep::parse(text, options.spec, options.sections);
  start = world.broadcast(start);
  auto attempts = broadcast(world, ledger ? ledger->attempts() : Attempts());
  const bool complete = world.broadcast(std::int64_t{ledger && ledger->table_is_complete()}) != 0;
  return OpenSweep{.sweep = *sweep,
                   .table = table,
                   .slice = options.slice,
                   .fresh = options.fresh,
                   .retry = options.retry,
                   .start = start,
                   .steady_start = steady_start,
                   .ledger = std::move(ledger),
                   .attempts = std::move(attempts),
                   .table_is_complete = complete};
}

}  // namespace sigmasweep
