#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/ledger/attempts.hpp"
#include "engine/stop/deadline.hpp"
#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/journal/journal.hpp"
#include "store/table/read.hpp"
#include "sweep/slice.hpp"

namespace sigmasweep {

/// The rows that a run begins with.
struct LedgerOptions {
  bool fresh = false;                ///< replace whatever is there
  Slice slice{};                     ///< the rows wanted
  bool extend = false;               ///< take over the rows of a table or journal of another spec at the same place
  std::vector<std::string> reuse{};  ///< other tables whose rows are taken over
  bool retry = false;                ///< leave out rows whose status is not reproducible: they are computed again
  TableInfo info{};                  ///< what a journal that is made says of the sweep
};

/// A row that a rank has computed and put into its journal.
struct RowDone {
  std::uint64_t index = 0;
  double run_time = 0.0, predicted_time = 0.0;  ///< s
};

/// What the manager knows of the rows of a sweep under way: which are there, and which are missing. The rows themselves
/// stand in the journals of the ranks; the manager has a bit of each.
class Ledger {
 public:
  /// Takes the lock, then looks for rows that are there already. A table that is complete for this spec gives all its
  /// rows. A journal gives its rows, if their parameters are still the same to the bit. A journal, even an empty one,
  /// is younger than the table beside it: a run removes it last, --fresh keeps the table until it can replace it, and
  /// no other run begins a journal beside a complete table. Rows that are taken over from elsewhere are written to the
  /// journal of rank 0 first.
  ///
  /// Throws SpecError (more rows than fit into memory; fewer than slices), InputNotFound, OutputError (locked; a table
  /// or journal of something else, unless `fresh` or, where possible, `extend`), IoError.
  Ledger(const Sweep& sweep, const std::string& table, const LedgerOptions& options);

  bool table_is_complete() const { return table_is_complete_; }
  std::uint64_t rows() const { return have_.size(); }  ///< of the slice
  std::uint64_t missing() const { return rows() - there_; }
  void for_each_missing(const std::function<void(std::uint64_t row)>& visit) const;
  std::uint64_t kept() const { return kept_; }  ///< number of rows that were there from the start
  /// Number of rows among them that were taken over from another sweep just now.
  std::uint64_t taken() const { return taken_; }
  const std::vector<std::string>& remarks() const { return remarks_; }  ///< on rows that were not taken over
  std::uint64_t there() const { return there_; }
  bool is_complete() const { return there_ == rows(); }
  /// What the rows that were there from the start say of predicted times.
  const CostFactor& learned() const { return learned_; }
  /// The attempts at rows that were tried before and are missing.
  const Attempts& attempts() const { return attempts_; }
  /// Reads the rows that are in the journals, in order of index.
  std::vector<Row> journalled() const;

  /// Enters rows that are in the journals of their ranks. Throws std::runtime_error for a row of another sweep.
  void enter(std::span<const RowDone> rows);
  bool has(std::uint64_t row) const;
  /// Enters a row that is not to be computed, as Status::quarantined. Throws IoError.
  void quarantine(const Tuple& tuple);
  /// The journal of rank 0. Throws OutputError.
  JournalFile& journal() { return journal_.file(); }
  /// Removes the journals, once the table is written and checked, or if the table was there already.
  void close() { journal_.remove(); }

 private:
  struct Source {
    std::string path, why_not;
    std::vector<Row> rows;
  };
  Ledger(const Sweep& sweep, const std::string& table, const LedgerOptions& options, const std::vector<Source>& others);
  static std::vector<Source> sources(const LedgerOptions& options);
  std::vector<Row> carry(const std::vector<JournalledRow>& old);
  void take_from_journal(const JournalledRow& found);
  void remark_on_journal();
  void take_table(const std::string& path, bool begun, bool extend);
  void take_rows(const Table& table, const std::string& path);
  void take_over(const Source& source);
  void keep(const Row& row);
  void keep_or_retry(const Row& row);
  void remember_attempt(const Row& row);
  bool mark(std::uint64_t row);

  Sweep sweep_;
  Slice slice_;
  bool retry_;
  std::uint64_t there_ = 0, kept_ = 0, taken_ = 0;
  std::vector<Field> results_;
  std::vector<bool> have_;
  std::vector<Row> new_;  // rows that are kept, but in no journal yet
  CostFactor learned_;
  Attempts attempts_;  // of rows that were tried before and are not kept
  std::vector<std::string> remarks_;
  Journal journal_;  // as it opens it gives its rows to the members above
  bool table_is_complete_ = false;
};

}  // namespace sigmasweep
