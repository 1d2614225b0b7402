// The journals of all ranks of a run are one set.
#include <gtest/gtest.h>

#include <algorithm>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/journal.hpp"
#include "store/journal/journal_fixture.hpp"
#include "store/journal/names.hpp"

namespace sigmasweep {
namespace {

using samples::bytes_of;
using samples::message_of;
using samples::put_bytes;
using samples::row;

class JournalsOfRanks : public JournalTest {
 protected:
  std::string other(int rank) const { return journal_of_rank(table, rank); }
  void write_by(int rank, std::initializer_list<std::uint64_t> indices) {
    JournalFile journal(other(rank), identity, {});
    journal.begin_alone();
    for (const auto index : indices) journal.append({{row(index)}});
  }
  std::vector<std::uint64_t> indices() const {
    std::vector<std::uint64_t> all;
    for (const JournalledRow& found : Journal(table, identity, false).recovered()) all.push_back(found.row.index);
    return all;
  }
  using Indices = std::vector<std::uint64_t>;
};

TEST_F(JournalsOfRanks, AreOneSet) {
  write({20, 21});
  write_by(1, {4, 30});
  write_by(12, {5});
  EXPECT_EQ(indices(), (Indices{4, 5, 20, 21, 30}));
  write_by(1, {31});  // goes on behind what is there
  EXPECT_EQ(indices(), (Indices{4, 5, 20, 21, 30, 31}));
  Journal(table, identity, false).remove();
  EXPECT_TRUE(directory.names().empty());
}

TEST_F(JournalsOfRanks, HandOnAllTheirRowsAndCountWhatIsDamaged) {
  write({20, 21});
  write_by(3, {4, 30});
  std::string damaged = bytes_of(other(3));
  damaged[header_size + 5] ^= 1;
  put_bytes(other(3), damaged + "torn");
  Indices visited;
  const Journal journal(table, identity, false, {}, {},
                        [&](const JournalledRow& found) { visited.push_back(found.row.index); });
  EXPECT_EQ(visited, (Indices{20, 21, 30}));
  EXPECT_EQ(journal.dropped(), 2u);
}

TEST_F(JournalsOfRanks, OneThatIsMissingCostsItsRowsOnly) {
  write({20, 21});
  write_by(1, {4});
  write_by(2, {5});
  std::filesystem::remove(other(1));
  EXPECT_EQ(indices(), (Indices{5, 20, 21}));
  std::filesystem::remove(path);
  Indices visited;
  Journal journal(table, identity, false, {}, {},
                  [&](const JournalledRow& found) { visited.push_back(found.row.index); });
  EXPECT_EQ(visited, (Indices{5}));
  EXPECT_FALSE(journal.is_there());
  journal.begin(0, {});
  EXPECT_EQ(indices(), (Indices{5}));
}

TEST_F(JournalsOfRanks, OneWithADamagedHeaderCostsItsRowsOnly) {
  for (const int damaged_rank : {0, 1}) {
    Journal(table, identity, true).append(row(20));
    write_by(1, {4});
    write_by(2, {5});
    std::string damaged = bytes_of(other(damaged_rank));
    damaged[20] ^= 1;
    put_bytes(other(damaged_rank), damaged);
    const Journal journal(table, identity, false);
    ASSERT_EQ(journal.passed_over().size(), 1u);
    EXPECT_TRUE(contains(journal.passed_over()[0], other(damaged_rank) + " is a journal with a damaged header"));
    EXPECT_EQ(journal.recovered().size(), 2u);
    write_by(1, {6});  // where it is damaged, it is made anew
    EXPECT_EQ(journal.recovered().size(), 3u);
  }
}

TEST_F(JournalsOfRanks, OfAnotherSweepArePassedOverBesideTheFirstAndRefusedWithoutIt) {
  JournalIdentity another = identity;
  ++another.spec_hash;
  Journal(table, another, true).append(row(1));
  { JournalFile(other(1), identity, {}).begin_alone(); }
  write({20});
  write_by(1, {4});
  {
    JournalFile journal(other(2), another, {});
    journal.begin_alone();
    journal.append({{row(7)}});
  }
  EXPECT_EQ(indices(), (Indices{4, 20}));
  std::filesystem::remove(path);
  std::filesystem::remove(other(1));
  EXPECT_TRUE(contains(message_of<OutputError>([&] { Journal(table, identity, false); }), "another sweep spec"));
  put_bytes(table, "a table");  // the run came to its end while it removed its journals
  EXPECT_FALSE(Journal(table, identity, false).is_there());
}

TEST_F(JournalsOfRanks, AreAllReplacedByAFreshStartAndByASweepThatTakesTheirRows) {
  write({20});
  write_by(1, {4});
  JournalIdentity another = identity;
  ++another.spec_hash;
  std::size_t offered = 0;
  const auto carry = [&](const std::vector<JournalledRow>& old, const std::optional<TableInfo>&) {
    offered = old.size();
    return std::optional(std::vector<Row>{row(3)});
  };
  EXPECT_EQ(Journal(table, another, false, carry).recovered().size(), 1u);
  EXPECT_EQ(offered, 2u);
  EXPECT_EQ(directory.names(), std::vector<std::string>{"t.h5.journal"});
  { JournalFile(other(5), another, {}).begin_alone(); }
  EXPECT_TRUE(Journal(table, identity, true).recovered().empty());
  EXPECT_EQ(directory.names(), std::vector<std::string>{"t.h5.journal"});
}

TEST_F(JournalsOfRanks, LeaveForeignFilesAlone) {
  write({20});
  for (const char* name : {"t.h5.journal.x", "t.h5.journal.01", "t.h5.journal.1.part", "t.h5.journal."})
    put_bytes(directory.file(name), "mine");
  put_bytes(other(1), "mine, too");
  EXPECT_EQ(indices(), (Indices{20}));
  EXPECT_TRUE(contains(message_of<OutputError>([&] { write_by(1, {3}); }), "is not a journal of sigmasweep"));
  Journal(table, identity, false).remove();
  EXPECT_EQ(bytes_of(other(1)), "mine, too");
  EXPECT_EQ(directory.names().size(), 5u);
}

TEST_F(JournalsOfRanks, HaveTheResultsOfTheSweepAndNoOthers) {
  const std::vector<Field> results{*std::ranges::find(result_fields(), "eps_eff", &Field::name)};
  const JournalIdentity slim{.spec_hash = 1, .physics_version = 7, .rows = 9, .results = results};
  {
    Journal journal(table, slim, true);
    const std::size_t empty = bytes_of(path).size();
    journal.append(row(4));
    EXPECT_EQ(bytes_of(path).size() - empty, 8u + 8u + 8u + 24u + 8u);  // index, key, eps_eff, timings, checksum
  }
  const std::vector<JournalledRow> found = Journal(table, slim, false).recovered();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found[0].row.result.eps_eff),
            std::bit_cast<std::uint64_t>(row(4).result.eps_eff));
  EXPECT_EQ(found[0].row.result.contacts, Row().result.contacts);
}

}  // namespace
}  // namespace sigmasweep
