#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mpi/blocks.hpp"
#include "mpi/rank_group.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/journal/open.hpp"
#include "store/journal/recover.hpp"
#include "store/table/packed_rows.hpp"
#include "sweep/slice.hpp"

namespace sigmasweep {

/// Brings the rows of a sweep from the journals, where they stand in the order in which they were computed, to the
/// ranks that write them: each rank has a contiguous block of the table. A block comes in pieces of bounded size. For
/// each piece all ranks read their journals, and send the rows that belong to it to their owners, in rounds of bounded
/// size. So memory does not grow with the number of rows. Rows that were computed several times count once
/// (precedence_of()).
class RowCollector {
 public:
  /// The most bytes of a piece on a rank, and of a round; at least one row.
  struct Limits {
    std::uint64_t piece_bytes = std::uint64_t{256} << 20, round_bytes = std::uint64_t{16} << 20;
  };
  /// `journals` are those that this rank reads, of this sweep or of anything else; together the ranks read each journal
  /// once. Collective.
  RowCollector(const RankGroup& ranks, const Sweep& sweep, const Slice& slice, std::vector<std::string> journals,
               Limits limits);
  RowCollector(const RankGroup& ranks, const Sweep& sweep, const Slice& slice, std::vector<std::string> journals)
      : RowCollector(ranks, sweep, slice, std::move(journals), Limits()) {}

  /// This rank's rows, as write_table() takes them. Its pieces throw IoError if rows are in no journal.
  BlockInPieces block();

 private:
  PackedBlock next_piece();
  bool belongs_to_piece(std::uint64_t place) const;
  void begin_piece();
  bool fill_round();
  bool open_next_journal();
  void put(const JournalledRow& found);
  void take(std::span<const std::byte> rows);

  const RankGroup& ranks_;
  const Sweep& sweep_;
  Slice slice_;
  std::vector<Field> results_;  ///< of a record
  std::vector<std::string> journals_;
  Blocks blocks_;
  Blocks::Block mine_;
  std::uint64_t piece_rows_, pieces_, round_bytes_;

  std::uint64_t next_piece_ = 0, offset_ = 0;  ///< of the piece in each block
  std::optional<PackedRows> piece_;
  std::vector<std::uint64_t> rank_of_;  ///< of each row of the piece: which record of it counts; 0: none is there
  std::size_t next_journal_ = 0;
  std::optional<OpenJournal> journal_;
  std::optional<RecordReader> reader_;
  std::optional<PackedRows> one_;  ///< room for a row
  std::vector<std::vector<std::byte>> to_each_;
};

}  // namespace sigmasweep
