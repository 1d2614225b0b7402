#include "store/stored/stored_rows.hpp"

#include <optional>
#include <utility>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/read.hpp"

namespace sigmasweep {
namespace {

StoredRows finished(Table table) {
  StoredRows stored;
  stored.total = table.rows.size();
  stored.table = std::move(table);
  return stored;
}

/// The table that a run wrote whose journals are still there, with all rows or without that of rank 0; nothing if the
/// table is of another sweep or not there.
std::optional<Table> table_of(const JournalledRows& journal, const std::string& path) {
  if (journal.has_first && journal.rows.size() < journal.total) return std::nullopt;
  try {
    Table table = read_table(path);
    if (table.info.spec_hash != journal.info.spec_hash || table.info.slice != journal.info.slice) return std::nullopt;
    return table;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

StoredRows read_stored_rows(const std::string& path) {
  auto journal = read_journal(path);
  if (!journal) return finished(read_table(path));
  if (auto table = table_of(*journal, path)) return finished(*std::move(table));
  StoredRows stored;
  stored.total = journal->total;
  stored.complete = false;
  stored.table.info = std::move(journal->info);
  for (const auto& [row, content_key] : journal->rows) {
    stored.table.rows.push_back(row);
    stored.content_keys.push_back(content_key);
  }
  return stored;
}

}  // namespace sigmasweep
