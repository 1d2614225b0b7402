#include "engine/ledger/ledger.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/random.hpp"
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

/// The identity of the journal; a slice of the sweep has another identity than the sweep. Throws SpecError where the
/// rows do not fit into half of this machine's memory (they are there twice while they are read back) or into the count
/// of a collective write, or where a slice could have no rows.
JournalIdentity identity_of(const Sweep& sweep, const Slice& slice) {
  if (slice.count > sweep.size())
    throw SpecError(fmt::format("{} rows are too few for {} slices", sweep.size(), slice.count));
  const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  const std::uint64_t rows = slice.size(sweep.size());
  const double needed = double(rows) * double(sizeof(Row));
  if (needed > memory / 2 || rows > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
    throw SpecError(fmt::format("{} rows take {:.3g} GB, this machine can hold {:.3g}: split the sweep", rows,
                                needed * 1e-9, memory / 2 * 1e-9));
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
    : slice_(options.slice),
      retry_(options.retry),
      journal_(
          table, identity_of(sweep, slice_), options.fresh,
          [&](const auto& old, const auto& theirs) -> std::optional<std::vector<Row>> {
            if (!options.extend && !(theirs && has_same_tuples(sweep, slice_, *theirs))) return std::nullopt;
            return carry(sweep, old);
          },
          options.info),
      rows_(slice_.size(sweep.size())),
      have_(rows_.size(), false) {
  if (journal_.is_locked_by_file())
    remarks_.push_back(
        fmt::format("warning: this file system has no locks; {}.owner keeps other runs away instead", table));
  take_journal(sweep);
  const bool begun = journal_.is_there(), beside_a_table = !options.fresh && std::filesystem::exists(table);
  if (beside_a_table && begun && there_ == 0)
    remarks_.push_back(fmt::format("{} is older than the fresh start that was begun, and will be replaced", table));
  if (beside_a_table && (!begun || options.extend)) take_table(sweep, table, begun, options.extend);
  for (const Source& other : others) take_over(sweep, other);
  if (!table_is_complete_) journal_.begin(std::exchange(new_, {}));
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

std::vector<Row> Ledger::carry(const Sweep& sweep, const std::vector<Row>& old) {
  std::vector<Row> rows = rows_among(old, sweep, slice_);
  taken_ += rows.size();
  return rows;
}

void Ledger::take_journal(const Sweep& sweep) {
  if (const auto dropped = journal_.dropped())
    remarks_.push_back(fmt::format("{} damaged or torn {} of the journal {} passed over; those rows are computed again",
                                   dropped, dropped == 1 ? "record" : "records", dropped == 1 ? "is" : "are"));
  for (const Row& row : journal_.recovered()) {
    if (!slice_.place(row.index)) continue;
    if (content_key(row.parameters) == content_key(sweep.at(row.index)))
      keep_or_retry(row);
    else
      attempts_[row.index] = row.timing.attempt;
  }
}

void Ledger::take_table(const Sweep& sweep, const std::string& path, bool begun, bool extend) {
  const Table table = table_at(path);
  if (is_of(table, sweep, slice_)) {
    if (begun) return;  // the journal is younger
    return take_rows(sweep, table, path);
  }
  if (!extend && table.info.spec_hash == sweep.hash())
    refuse(path, "is there already and is the table of another slice of this spec");
  if (!extend)
    refuse(path, "is there already and is the table of another spec",
           "Run it with --extend, which takes over the rows that are the same. Or: ");
  ReusableRows found = reusable_rows(path);
  if (!found.why_not.empty()) refuse(path, found.why_not);
  take_over(sweep, {path, {}, std::move(found.rows)});
}

/// Takes the rows of the table of this sweep. If some of them are to be tried again, the journal begins with the
/// others.
void Ledger::take_rows(const Sweep& sweep, const Table& table, const std::string& path) {
  if (const std::string why_not = why_other_physics(table.info); !why_not.empty()) refuse(path, why_not);
  if (!has_axes_of(sweep, table.rows)) refuse(path, "was computed by a program that reads its spec otherwise");
  for (const Row& row : table.rows) keep_or_retry(row);
  table_is_complete_ = is_complete();
  if (table_is_complete_) return;
  if (const std::string why_not = why_other_build(table.info); !why_not.empty()) refuse(path, why_not);
  for (std::uint64_t k = 0; k < rows_.size(); ++k) {
    if (!have_[k]) continue;
    rows_[k].parameters = sweep.at(rows_[k].index);  // the table has only those that are columns
    new_.push_back(rows_[k]);
  }
}

void Ledger::take_over(const Sweep& sweep, const Source& source) {
  if (!source.why_not.empty())
    remarks_.push_back(fmt::format("nothing taken over: {} {}", source.path, source.why_not));
  for (const Row& row : rows_among(source.rows, sweep, slice_)) {
    if (have_[*slice_.place(row.index)]) continue;
    new_.push_back(row);
    keep(row);
    ++taken_;
  }
}

void Ledger::keep(const Row& row) {
  const std::uint64_t k = *slice_.place(row.index);
  rows_[k] = row;
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
    if (const auto place = slice_.place(row.index); !place || *place >= rows_.size())
      throw std::runtime_error(fmt::format("a rank answered with row {}, which is not of this sweep", row.index));
    const auto tried = attempts_.empty() ? attempts_.end() : attempts_.find(row.index);
    row.timing.attempt = tried == attempts_.end() ? 1 : tried->second + 1;
  }
  journal_.append(rows);
  for (const Row& row : rows) keep(row);
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
