#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <set>
#include <utility>

#include "base/exit_codes.hpp"
#include "base/standard_error.hpp"
#include "cli/command.hpp"
#include "engine/ledger/ledger.hpp"
#include "engine/report/summary.hpp"
#include "engine/stop/stop_signals.hpp"
#include "mpi/on_root.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/stored/stored_sweep.hpp"
#include "store/table/place.hpp"
#include "store/table/read.hpp"
#include "store/table/write.hpp"

namespace sigmasweep {
namespace {

struct MergeOptions {
  std::string output;              ///< path of the merged table
  std::vector<std::string> parts;  ///< paths of the slices' tables
  bool fresh = false;              ///< replace an existing table
  bool quiet = false;
};

[[noreturn]] void refuse(const std::string& why) { throw Error(exit_code::bad_data, why + "; nothing was written"); }

/// The table of a part. Its spec must be that of the first part, and its rows must be of this program's physics.
Table read_part(const std::string& path, const TableInfo* first) {
  StoredSweep part = read_stored_sweep(path);
  if (!part.complete) refuse(incomplete_line(part, path));
  if (const std::string why_not = why_not_ours(part); !why_not.empty()) refuse(fmt::format("{} {}", path, why_not));
  const TableInfo& info = part.table.info;
  if (first != nullptr && info.spec_hash != first->spec_hash)
    refuse(
        fmt::format("{} is of another spec (its hash is {:016x}, that of the first part {:016x}); a spec with the "
                    "rows of both takes them over with 'sigmasweep run SPEC.toml --reuse {}' (and --reuse of others)",
                    path, info.spec_hash, first->spec_hash, path));
  return std::move(part.table);
}

bool same_bits(const Row& a, const Row& b) {
  return std::ranges::all_of(result_fields(), [&](const Field& field) {
    return std::bit_cast<std::uint64_t>(number(field, a)) == std::bit_cast<std::uint64_t>(number(field, b));
  });
}

bool is_there(const Row& row) { return row.result.status != Status::not_run; }

/// Adds the rows of `part`. Throws if another part has a row with a different result.
void add(std::vector<Row>& rows, const Table& part, const std::string& path) {
  std::string differing;
  std::uint64_t count = 0;
  for (const Row& row : part.rows) {
    Row& there = rows[row.index];
    if (!is_there(there))
      there = row;
    else if (!same_bits(there, row) && ++count <= 10)
      differing += fmt::format("{}{}", count > 1 ? ", " : "", row.index);
  }
  if (count > 0)
    refuse(fmt::format("{} has {} rows with other results than another part has for them: {}{}", path, count, differing,
                       count > 10 ? ", ..." : ""));
}

/// Throws if rows are missing, with the numbers of their slices.
void require_all(const std::vector<Row>& rows, std::uint64_t slices) {
  std::uint64_t missing = 0;
  std::set<std::uint64_t> missing_slices;
  for (std::uint64_t row = 0; row < rows.size(); ++row) {
    if (is_there(rows[row])) continue;
    ++missing;
    missing_slices.insert(Slice::with(row, slices).index);
  }
  if (missing == 0) return;
  std::string names;
  for (const std::uint64_t slice : missing_slices)
    names += fmt::format("{}{}/{}", names.empty() ? "" : ", ", slice, slices);
  refuse(fmt::format("{} of {} rows are missing, those of slice{} {}", missing, rows.size(),
                     missing_slices.size() > 1 ? "s" : "", names));
}

/// Joins the tables of slices. Throws Error with exit code 65 if the parts do not fit together or rows are missing.
int merge(const MergeOptions& options) {
  require_place_for_table(options.output, options.parts);
  Table first = read_part(options.parts.front(), nullptr);
  const Sweep sweep = Sweep::parse_stored(first.info.spec_text, options.parts.front());
  TableInfo whole = first.info;
  whole.slice = {};
  Ledger ledger(sweep, options.output, LedgerOptions{.fresh = options.fresh, .info = std::move(whole)});
  if (ledger.table_is_complete()) {
    ledger.close();
    if (!options.quiet) print_on_stderr(fmt::format("sigmasweep: {} is complete, nothing to merge\n", options.output));
    return 0;
  }
  TableInfo info = first.info;
  info.ranks = 0;
  std::vector<Row> rows(sweep.size());
  for (std::uint64_t k = 0; k < sweep.size(); ++k) rows[k] = {k, sweep.at(k), {}, {}};
  for (const Row& row : ledger.journalled()) rows[row.index] = row;
  std::uint64_t slices = 1;
  try {
    for (std::size_t i = 0; i < options.parts.size(); ++i) {
      if (StopSignals::came())
        throw Error(exit_code::stopped, "stopped before all parts were read; nothing was written");
      const Table part = i == 0 ? std::exchange(first, {}) : read_part(options.parts[i], &info);
      add(rows, part, options.parts[i]);
      slices = std::max(slices, part.info.slice.count);
      info.start = std::min(info.start, part.info.start);  // ISO 8601 sorts as text
      info.ranks += part.info.ranks;
    }
    require_all(rows, slices);
    info.slice = {};
    write_table(MPI_COMM_SELF, options.output, info, sweep.columns(), rows.size(), 0, rows);
  } catch (const Error&) {
    if (ledger.there() == 0) ledger.close();  // a journal of no rows
    throw;
  }
  ledger.close();
  if (!options.quiet)
    print_on_stderr(fmt::format("{}: {} rows from {} tables\n{}", options.output, rows.size(), options.parts.size(),
                                summary(rows, Work{}, 1, 0.0)));
  const bool fine = std::ranges::all_of(rows, [](const Row& row) { return is_success(row.result.status); });
  return fine ? exit_code::success : exit_code::some_rows_failed;
}

/// Merges on the manager, while the other ranks wait for it.
int merge_on_root(World& world, const MergeOptions& options) {
  return run_on_root(world, [&] { return merge(options); });
}

void declare(OptionSet& set, MergeOptions& options) {
  set.add({"output", "The merged table", "TABLE.h5"}, options.output);
  set.add({"parts", "Tables of one spec, which together have all its rows", "PART.h5..."}, options.parts,
          Several::arguments);
  set.add_flag("--fresh", "Replace an existing table", options.fresh);
  set.add_flag("-q,--quiet", "No summary", options.quiet);
}

}  // namespace

Command merge_command() {
  return make_command(
      "merge", "Join the tables of a sweep's slices",
      "\nThe results are those of a run that was not divided, bit for bit. The parts are left as they are.\n\n"
      "  sigmasweep run fig2a.toml --slice 0/2 -o part0.h5\n"
      "  sigmasweep run fig2a.toml --slice 1/2 -o part1.h5\n"
      "  sigmasweep merge fig2a.h5 part0.h5 part1.h5",
      declare, merge_on_root);
}

}  // namespace sigmasweep
