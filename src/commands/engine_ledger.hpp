#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sigmasweep/store/journal.hpp"
#include "sigmasweep/sweep/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The manager's view of a sweep under way: which rows are there, which are still to do, and the journal where each is
/// kept as it comes in.
class Ledger {
 public:
  /// Takes the lock, then looks at what is there already. A table that is complete for this spec gives all its rows;
  /// a journal gives the rows it has, if their parameters are still the same to the bit. A journal with rows is younger
  /// than the table beside it (the run removes it last, and --fresh keeps the table until it can replace it).
  /// Throws SpecError (more rows than fit into memory), OutputError (locked; a table or journal of something else, unless `fresh`), IoError.
  Ledger(const Sweep& sweep, const std::string& table, bool fresh);

  bool table_is_complete() const { return table_is_complete_; }
  std::vector<std::uint64_t> missing() const;
  std::uint64_t kept() const { return kept_; }  ///< rows there from the start
  std::uint64_t there() const { return there_; }
  bool is_complete() const { return there_ == rows_.size(); }
  const std::vector<Row>& rows() const { return rows_; }  ///< in spec order; status not_run where missing

  /// A row came in: to the journal, then to rows(). Throws IoError.
  void enter(Row row);
  void sync() { journal_.sync(); }
  /// The table is written and checked, or was there: the journal is not needed any more.
  void close() { journal_.remove(); }

 private:
  void take_journal(const Sweep& sweep);
  void take_table(const Sweep& sweep, const std::string& path);
  void keep(const Row& row);

  Journal journal_;
  std::vector<Row> rows_;
  std::vector<bool> have_;
  std::map<std::uint64_t, std::int32_t> attempts_;  // of rows that were tried before and are not kept
  std::uint64_t there_ = 0, kept_ = 0;
  bool table_is_complete_ = false;
};

}  // namespace sigmasweep
