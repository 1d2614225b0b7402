#include "engine/ledger/ledger.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/ledger/identity.hpp"
#include "engine/ledger/needs.hpp"
#include "engine/ledger/reuse.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what, std::string_view first_advice = "") {
  throw OutputError(
      fmt::format("{}: {}; nothing was changed. {}Choose another output with -o, or --fresh to replace it", path, what,
                  first_advice));
}

/// The number of rows that are wanted. Throws SpecError where a slice could have no rows, or where the rows are too
/// many for this machine.
std::uint64_t checked_rows(const Sweep& sweep, const Slice& slice) {
  if (slice.count > sweep.size())
    throw SpecError(fmt::format("{} rows are too few for {} slices", sweep.size(), slice.count));
  const std::uint64_t rows = slice.size(sweep.size());
  if (const std::string why = why_too_many(sweep, rows); !why.empty()) throw SpecError(why);
  return rows;
}

/// The table at `path`. Throws OutputError for anything else.
Table table_at(const std::string& path) {
  try {
    return read_table(path);
  } catch (const Error&) {
    refuse(path, "is there already and is not a whole sigmasweep table");
  }
}

bool is_of(const Table& table, const Sweep& sweep, const Slice& slice) {
  return table.info.spec_hash == sweep.hash() && table.info.spec_text == sweep.text() && table.info.slice == slice &&
         table.rows.size() == slice.size(sweep.size());
}

}  // namespace

Ledger::Ledger(const Sweep& sweep, const std::string& table, const LedgerOptions& options)
    : Ledger(sweep, table, options, sources(options)) {}

Ledger::Ledger(const Sweep& sweep, const std::string& table, const LedgerOptions& options,
               const std::vector<Source>& others)
    : sweep_(sweep),
      slice_(options.slice),
      retry_(options.retry),
      results_(journalled_results(sweep)),
      have_(checked_rows(sweep, slice_), false),
      journal_(
          table, journal_identity(sweep, slice_, results_), options.fresh,
          [&](const auto& old, const auto& theirs) -> std::optional<std::vector<Row>> {
            if (!options.extend && !(theirs && has_same_tuples(sweep, slice_, *theirs))) return std::nullopt;
            return carry(old);
          },
          options.info, [this](const JournalledRow& found) { take_from_journal(found); }) {
  if (journal_.is_locked_by_file())
    remarks_.push_back(
        fmt::format("warning: this file system has no locks; {}.owner keeps other runs away instead", table));
  remark_on_journal();
  const bool begun = journal_.is_there(), beside_a_table = !options.fresh && std::filesystem::exists(table);
  for (const std::string& passed_over : journal_.passed_over())
    remarks_.push_back(fmt::format("{}; it is passed over, and its rows are computed again", passed_over));
  if (beside_a_table && begun && there_ == 0)
    remarks_.push_back(fmt::format("{} is older than the fresh start that was begun, and will be replaced", table));
  if (beside_a_table && (!begun || options.extend)) take_table(table, begun, options.extend);
  for (const Source& other : others) take_over(other);
  if (!table_is_complete_) journal_.begin(new_.size(), [this](std::uint64_t k) { return new_[k]; });
  new_ = {};
  kept_ = there_;
}

std::vector<Ledger::Source> Ledger::sources(const LedgerOptions& options) {
  std::vector<Source> sources;
  for (const std::string& path : options.reuse) {
    ReusableRows found = reusable_rows(path);
    sources.push_back({path, std::move(found.why_not), std::move(found.rows)});
  }
  return sources;
}

std::vector<Row> Ledger::carry(const std::vector<JournalledRow>& old) {
  std::vector<Row> rows = rows_among(old, sweep_, slice_);
  taken_ += rows.size();
  return rows;
}

void Ledger::remark_on_journal() {
  if (const auto dropped = journal_.dropped())
    remarks_.push_back(fmt::format("{} damaged or torn {} of the journal {} passed over; those rows are computed again",
                                   dropped, dropped == 1 ? "record" : "records", dropped == 1 ? "is" : "are"));
}

void Ledger::take_from_journal(const JournalledRow& found) {
  if (!slice_.place(found.row.index)) return;
  if (found.content_key == content_key(sweep_.at(found.row.index)))
    keep_or_retry(found.row);
  else
    remember_attempt(found.row);
}

void Ledger::take_table(const std::string& path, bool begun, bool extend) {
  const Table table = table_at(path);
  if (is_of(table, sweep_, slice_)) {
    if (begun) return;  // the journals are younger
    return take_rows(table, path);
  }
  if (there_ > 0 && !extend) return;  // so are those of other ranks, where that of rank 0 is missing
  if (!extend && table.info.spec_hash == sweep_.hash())
    refuse(path, "is there already and is the table of another slice of this spec");
  if (!extend)
    refuse(path, "is there already and is the table of another spec",
           "Run it with --extend, which takes over the rows that are the same. Or: ");
  ReusableRows found = reusable_rows(path);
  if (!found.why_not.empty()) refuse(path, found.why_not);
  take_over({path, {}, std::move(found.rows)});
}

/// Takes the rows of the table of this sweep. If some of them are to be tried again, the journal begins with the
/// others.
void Ledger::take_rows(const Table& table, const std::string& path) {
  if (const std::string why_not = why_other_physics(table.info); !why_not.empty()) refuse(path, why_not);
  if (!has_axes_of(sweep_, table.rows)) refuse(path, "was computed by a program that reads its spec otherwise");
  for (const Row& row : table.rows) keep_or_retry(row);
  table_is_complete_ = is_complete();
  if (table_is_complete_) return;
  if (const std::string why_not = why_other_build(table.info); !why_not.empty()) refuse(path, why_not);
  for (const Row& row : table.rows)
    if (has(row.index)) new_.push_back({row.index, sweep_.at(row.index), row.result, row.timing});
}

void Ledger::take_over(const Source& source) {
  if (!source.why_not.empty())
    remarks_.push_back(fmt::format("nothing taken over: {} {}", source.path, source.why_not));
  for (const Row& row : rows_among(source.rows, sweep_, slice_)) {
    if (has(row.index)) continue;
    new_.push_back(row);
    keep(row);
    ++taken_;
  }
}

/// Returns whether the row was missing.
bool Ledger::mark(std::uint64_t row) {
  const std::uint64_t k = *slice_.place(row);
  if (have_[k]) return false;
  have_[k] = true;
  ++there_;
  return true;
}

void Ledger::keep(const Row& row) {
  if (mark(row.index)) learned_.learn(row.timing);
}

void Ledger::keep_or_retry(const Row& row) {
  if (!retry_ || is_reproducible(row.result.status))
    keep(row);
  else
    remember_attempt(row);
}

void Ledger::remember_attempt(const Row& row) {
  std::int32_t& attempt = attempts_[row.index];
  attempt = std::max(attempt, row.timing.attempt);
}

void Ledger::for_each_missing(const std::function<void(std::uint64_t row)>& visit) const {
  for (std::uint64_t k = 0; k < have_.size(); ++k)
    if (!have_[k]) visit(slice_.row(k));
}

void Ledger::enter(std::span<const RowDone> rows) {
  for (const RowDone& row : rows) {
    if (const auto place = slice_.place(row.index); !place || *place >= have_.size())
      throw std::runtime_error(fmt::format("a rank answered with row {}, which is not of this sweep", row.index));
    mark(row.index);
  }
}

std::vector<Row> Ledger::journalled() const {
  std::vector<Row> rows;
  for (const auto& [found, key] : journal_.recovered()) {
    Row row{.index = found.index, .parameters = sweep_.at(found.index), .result = found.result, .timing = found.timing};
    if (slice_.place(row.index) && content_key(row.parameters) == key) rows.push_back(row);
  }
  return rows;
}

bool Ledger::has(std::uint64_t row) const {
  const auto place = slice_.place(row);
  return place && have_[*place];
}

void Ledger::quarantine(const Tuple& tuple) {
  if (!slice_.place(tuple.index)) return;
  Row row{.index = tuple.index, .parameters = tuple.parameters, .result = {}, .timing = {}};
  row.result.status = Status::quarantined;
  row.timing.attempt = next_attempt(attempts_, row.index);
  journal_.append(row);
  mark(row.index);
  ++kept_;
}

}  // namespace sigmasweep
