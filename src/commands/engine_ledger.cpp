#include "engine_ledger.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <utility>

#include "sigmasweep/errors.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/store/table.hpp"

namespace sigmasweep {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw OutputError(fmt::format("{}: {}; nothing was changed. Choose another output with -o, or --fresh to replace it",
                                path, what));
}

/// What the journal belongs to. Throws SpecError where the rows do not fit into this machine's memory (half of it, as
/// they are there twice while they are read back) or the count of a collective write.
JournalIdentity identity_of(const Sweep& sweep) {
  const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  const double needed = double(sweep.size()) * double(sizeof(Row));
  if (needed > memory / 2 || sweep.size() > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
    throw SpecError(fmt::format("{} rows take {:.3g} GB, this machine can hold {:.3g}: split the sweep", sweep.size(),
                                needed * 1e-9, memory / 2 * 1e-9));
  return {sweep.hash(), physics_version, sweep.size()};
}

/// The table at `path`, which must be this sweep's.
Table table_of(const Sweep& sweep, const std::string& path) {
  Table table;
  try {
    table = read_table(path);
  } catch (const Error&) {
    refuse(path, "is there already and is not a whole sigmasweep table");
  }
  if (table.info.spec_hash != sweep.hash() || table.rows.size() != sweep.size())
    refuse(path, "is there already and is the table of another spec");
  if (table.info.physics_version != physics_version)
    refuse(path, fmt::format("was computed with physics version {}, this program has {}", table.info.physics_version,
                             physics_version));
  return table;
}

}  // namespace

Ledger::Ledger(const Sweep& sweep, const std::string& table, bool fresh)
    : journal_(table, identity_of(sweep), fresh),
      rows_(sweep.size()), have_(sweep.size(), false) {
  take_journal(sweep);
  const bool begun = !journal_.recovered().empty();
  try {
    if (!begun && !fresh && std::filesystem::exists(table)) take_table(sweep, table);
  } catch (const Error&) {
    journal_.remove();  // it is empty: leave nothing behind
    throw;
  }
  kept_ = there_;
}

void Ledger::take_journal(const Sweep& sweep) {
  for (const Row& row : journal_.recovered()) {
    if (row.index >= rows_.size()) continue;
    if (content_key(row.parameters) == content_key(sweep.at(row.index))) keep(row);
    else attempts_[row.index] = row.timing.attempt;
  }
}

void Ledger::take_table(const Sweep& sweep, const std::string& path) {
  for (const Row& row : table_of(sweep, path).rows) keep(row);
  table_is_complete_ = true;
}

void Ledger::keep(const Row& row) {
  rows_[row.index] = row;
  if (!have_[row.index]) ++there_;
  have_[row.index] = true;
}

std::vector<std::uint64_t> Ledger::missing() const {
  std::vector<std::uint64_t> missing;
  for (std::uint64_t row = 0; row < have_.size(); ++row)
    if (!have_[row]) missing.push_back(row);
  return missing;
}

void Ledger::enter(Row row) {
  const auto tried = attempts_.find(row.index);
  row.timing.attempt = tried == attempts_.end() ? 1 : tried->second + 1;
  journal_.append(row);
  keep(row);
}

}  // namespace sigmasweep
