#include "engine/ledger/ledger.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/random.hpp"
#include "engine/ledger/needs.hpp"
#include "engine/ledger/reuse.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/physics_version.hpp"
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

/// The identity of the journal; a slice of the sweep has another identity than the sweep.
JournalIdentity identity_of(const Sweep& sweep, const Slice& slice) {
  const std::uint64_t hash =
      slice.is_whole() ? sweep.hash() : random_bits(sweep.hash() ^ random_bits(slice.count, slice.index), 0);
  return {hash, physics_version, sweep.size()};
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
      packed_(sweep.columns(), checked_rows(sweep, slice_)),
      have_(packed_.size(), false),
      journal_(
          table, identity_of(sweep, slice_), options.fresh,
          [&](const auto& old, const auto& theirs) -> std::optional<std::vector<Row>> {
            if (!options.extend && !(theirs && has_same_tuples(sweep, slice_, *theirs))) return std::nullopt;
            return carry(old);
          },
          options.info, [this](const Row& row) { take_from_journal(row); }) {
  if (journal_.is_locked_by_file())
    remarks_.push_back(
        fmt::format("warning: this file system has no locks; {}.owner keeps other runs away instead", table));
  remark_on_journal();
  const bool begun = journal_.is_there(), beside_a_table = !options.fresh && std::filesystem::exists(table);
  if (beside_a_table && begun && there_ == 0)
    remarks_.push_back(fmt::format("{} is older than the fresh start that was begun, and will be replaced", table));
  if (beside_a_table && (!begun || options.extend)) take_table(table, begun, options.extend);
  for (const Source& other : others) take_over(other);
  if (!table_is_complete_) journal_.begin(new_.size(), [this](std::uint64_t k) { return row(new_[k]); });
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

std::vector<Row> Ledger::carry(const std::vector<Row>& old) {
  std::vector<Row> rows = rows_among(old, sweep_, slice_);
  taken_ += rows.size();
  return rows;
}

void Ledger::remark_on_journal() {
  if (const auto dropped = journal_.dropped())
    remarks_.push_back(fmt::format("{} damaged or torn {} of the journal {} passed over; those rows are computed again",
                                   dropped, dropped == 1 ? "record" : "records", dropped == 1 ? "is" : "are"));
}

/// The last record of a row counts.
void Ledger::take_from_journal(const Row& row) {
  if (!slice_.place(row.index)) return;
  if (content_key(row.parameters) == content_key(sweep_.at(row.index)))
    keep_or_retry(row);
  else
    attempts_[row.index] = row.timing.attempt;
}

void Ledger::take_table(const std::string& path, bool begun, bool extend) {
  const Table table = table_at(path);
  if (is_of(table, sweep_, slice_)) {
    if (begun) return;  // the journal is younger
    return take_rows(table, path);
  }
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
  for (std::uint64_t k = 0; k < packed_.size(); ++k)
    if (have_[k]) new_.push_back(k);
}

void Ledger::take_over(const Source& source) {
  if (!source.why_not.empty())
    remarks_.push_back(fmt::format("nothing taken over: {} {}", source.path, source.why_not));
  for (const Row& row : rows_among(source.rows, sweep_, slice_)) {
    if (have_[*slice_.place(row.index)]) continue;
    new_.push_back(*slice_.place(row.index));
    keep(row);
    ++taken_;
  }
}

void Ledger::keep(const Row& row) {
  const std::uint64_t k = *slice_.place(row.index);
  packed_.set(k, row);
  if (!have_[k]) ++there_;
  have_[k] = true;
}

void Ledger::keep_or_retry(const Row& row) {
  if (!retry_ || is_reproducible(row.result.status))
    keep(row);
  else
    attempts_[row.index] = row.timing.attempt;
}

void Ledger::for_each_missing(const std::function<void(std::uint64_t row)>& visit) const {
  for (std::uint64_t k = 0; k < have_.size(); ++k)
    if (!have_[k]) visit(slice_.row(k));
}

void Ledger::enter(std::span<Row> rows) {
  for (Row& row : rows) {
    if (const auto place = slice_.place(row.index); !place || *place >= packed_.size())
      throw std::runtime_error(fmt::format("a rank answered with row {}, which is not of this sweep", row.index));
    const auto tried = attempts_.empty() ? attempts_.end() : attempts_.find(row.index);
    row.timing.attempt = tried == attempts_.end() ? 1 : tried->second + 1;
  }
  journal_.append(rows);
  for (const Row& row : rows) keep(row);
}

Row Ledger::row(std::uint64_t place) const {
  const std::uint64_t index = slice_.row(place);
  Row row{.index = index, .parameters = sweep_.at(index), .result = {}, .timing = {}};
  packed_.get(place, row);
  return row;
}

bool Ledger::has(std::uint64_t row) const {
  const auto place = slice_.place(row);
  return place && have_[*place];
}

void Ledger::quarantine(const Tuple& tuple) {
  if (!slice_.place(tuple.index)) return;
  Row row{.index = tuple.index, .parameters = tuple.parameters, .result = {}, .timing = {}};
  row.result.status = Status::quarantined;
  enter({&row, 1});
  ++kept_;
}

}  // namespace sigmasweep
