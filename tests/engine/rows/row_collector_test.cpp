// The rows of any journals, in any order, come to the ranks that write them.
#include "engine/rows/row_collector.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <memory>
#include <random>

#include "engine/ledger/identity.hpp"
#include "engine/rows/row_keeper.hpp"
#include "mpi/run_collective.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/journal/names.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

constexpr const char* spec = R"(
[sweep]
method = "ed"
v0 = 0.1
tc = 1e-5
epsilon = { from = 0.5, to = 0.9, count = 300 }
N = [2, 3]
sigma = 0.5
)";

class Collector : public testing::Test {
 protected:
  void SetUp() override {
    std::string name(4096, '\0');
    if (ranks_.rank() == 0) own_ = std::make_unique<samples::Directory>();
    if (own_) own_->file("t.h5").copy(name.data(), 4095);
    table_ = ranks_.broadcast(name).c_str();
  }
  void TearDown() override { MPI_Barrier(MPI_COMM_WORLD); }

  Row row(std::uint64_t index, std::int32_t attempt = 1, Status status = Status::ok) const {
    Row row{.index = index, .parameters = sweep_.at(index), .result = {}, .timing = {}};
    row.result.status = status;
    row.result.eps_eff = 1.0 / static_cast<double>(index + 1) + attempt;
    row.timing.attempt = attempt;
    return row;
  }

  /// On rank 0. What the journal of a rank holds.
  void write(int rank, const std::vector<Row>& rows, const Slice& slice = {}) const {
    const std::vector<Field> results = journalled_results(sweep_);
    JournalFile journal(journal_of_rank(table_, rank), journal_identity(sweep_, slice, results), {});
    journal.begin_alone();
    journal.append(rows);
  }
  /// On rank 0. All rows but some, shuffled, in so many journals.
  void write_all(int journals, const std::vector<std::uint64_t>& but = {}) const {
    std::vector<Row> rows;
    for (std::uint64_t index = 0; index < sweep_.size(); ++index)
      if (std::ranges::find(but, index) == but.end()) rows.push_back(row(index));
    std::shuffle(rows.begin(), rows.end(), std::mt19937(7));
    for (int rank = 0; rank < journals; ++rank) {
      std::vector<Row> part;
      for (std::size_t k = static_cast<std::size_t>(rank); k < rows.size(); k += static_cast<std::size_t>(journals))
        part.push_back(rows[k]);
      write(rank, part);
    }
  }

  /// Every size-th journal.
  std::vector<std::string> journals(int count) const {
    std::vector<std::string> mine;
    for (int rank = ranks_.rank(); rank < count; rank += ranks_.size()) mine.push_back(journal_of_rank(table_, rank));
    return mine;
  }

  /// The rows that come to this rank.
  std::vector<Row> collect(std::vector<std::string> journals, const Slice& slice = {},
                           RowCollector::Limits limits = {}) {
    RowCollector collector(ranks_, sweep_, slice, std::move(journals), limits);
    const BlockInPieces block = collector.block();
    EXPECT_EQ(ranks_.sum_before(block.rows), block.first);
    std::vector<Row> rows;
    for (std::uint64_t piece = 0; piece < block.pieces; ++piece) {
      const PackedBlock packed = block.next();
      EXPECT_EQ(packed.first, block.first + rows.size());
      PackedRows some(sweep_.columns(), packed.rows);
      std::ranges::copy(packed.sections[0], some.results().bytes.begin());
      std::ranges::copy(packed.sections[1], some.timings().bytes.begin());
      for (std::uint64_t k = 0; k < packed.rows; ++k) some.get(k, rows.emplace_back());
    }
    EXPECT_EQ(rows.size(), block.rows);
    first_ = block.first;
    return rows;
  }

  void expect_all(const std::vector<Row>& rows) const {
    EXPECT_EQ(ranks_.sum(rows.size()), sweep_.size());
    for (std::size_t k = 0; k < rows.size(); ++k) ASSERT_EQ(rows[k].result.eps_eff, row(first_ + k).result.eps_eff);
  }
  template <class Step>
  void on_rank_0(Step step) {
    if (ranks_.rank() == 0) step();
    MPI_Barrier(MPI_COMM_WORLD);
  }

  const Sweep sweep_ = Sweep::parse(spec, "spec");
  const RankGroup ranks_{MPI_COMM_WORLD};
  std::unique_ptr<samples::Directory> own_;
  std::string table_;
  std::uint64_t first_ = 0;
};

TEST_F(Collector, BringsTheRowsOfAnyNumberOfJournalsToTheirPlaces) {
  for (const int count : {1, 2, 3, 7}) {
    on_rank_0([&] {
      for (int rank = 0; rank < 8; ++rank) std::filesystem::remove(journal_of_rank(table_, rank));
      write_all(count);
    });
    expect_all(collect(journals(count)));
  }
}

TEST_F(Collector, NeedsNoMoreMemoryThanItsLimits) {
  on_rank_0([&] { write_all(3); });
  for (const std::uint64_t bytes : {1u, 1000u, 30'000u})
    expect_all(collect(journals(3), {}, {.piece_bytes = bytes, .round_bytes = 1}));
}

TEST_F(Collector, OfSeveralRecordsOfARowOneCounts) {
  on_rank_0([&] {
    write_all(1, {0, 5, 599});
    write(1, {row(5, 3), row(0, 1, Status::time_limit), row(599, 2, Status::time_limit)});
    write(2, {row(5, 2), row(0, 1), row(599, 1)});
  });
  for (const Row& found : collect(journals(3))) {
    EXPECT_EQ(found.timing.attempt == 3, found.result.eps_eff == row(5, 3).result.eps_eff);
    EXPECT_EQ(found.timing.attempt == 2, found.result.status == Status::time_limit);
  }
  EXPECT_EQ(ranks_.sum(static_cast<std::uint64_t>(
                std::ranges::count(collect(journals(3)), 3, [](const Row& found) { return found.timing.attempt; }))),
            1u);
}

TEST_F(Collector, EveryRankHearsOfRowsThatAreInNoJournal) {
  on_rank_0([&] { write_all(2, {17, 500}); });
  const std::string message = samples::message_of<IoError>([&] { collect(journals(2)); });
  EXPECT_NE(message.find("2 rows"), std::string::npos) << message;
}

TEST_F(Collector, TakesNothingFromJournalsOfAnotherSweepOrOfNothing) {
  on_rank_0([&] {
    write_all(2);
    write(2, {row(3, 9)}, {1, 2});
    samples::put_bytes(journal_of_rank(table_, 3), "hello");
  });
  expect_all(collect(journals(5)));
}

TEST_F(Collector, BringsTheRowsOfASlice) {
  const Slice slice{.index = 1, .count = 3};
  on_rank_0([&] {
    std::vector<Row> rows;
    for (std::uint64_t k = slice.size(sweep_.size()); k > 0; --k) rows.push_back(row(slice.row(k - 1)));
    write(0, rows, slice);
  });
  const std::vector<Row> rows = collect(journals(1), slice);
  EXPECT_EQ(ranks_.sum(rows.size()), slice.size(sweep_.size()));
  for (std::size_t k = 0; k < rows.size(); ++k)
    EXPECT_EQ(rows[k].result.eps_eff, row(slice.row(first_ + k)).result.eps_eff);
}

TEST_F(Collector, KeptRowsHaveTheirAttempts) {
  if (ranks_.rank() != 0) return;
  const std::vector<Field> results = journalled_results(sweep_);
  JournalFile journal(journal_of_rank(table_, 4), journal_identity(sweep_, {}, results), {});
  RowKeeper keeper(journal, {{7, 2}});
  std::vector<Row> rows{row(7), row(8)};
  EXPECT_TRUE(keeper.keep(rows));
  EXPECT_FALSE(keeper.has_failed());
  EXPECT_EQ(rows[0].timing.attempt, 3);
  EXPECT_EQ(rows[1].timing.attempt, 1);
  keeper.finish();
  journal.remove();
  EXPECT_FALSE(keeper.keep(rows));
  EXPECT_TRUE(keeper.has_failed());
  EXPECT_THROW(keeper.finish(), IoError);
}

}  // namespace
}  // namespace sigmasweep
