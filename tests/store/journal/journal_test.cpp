#include "store/journal/journal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/names.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using samples::bits;
using samples::bytes_of;
using samples::message_of;
using samples::put_bytes;
using samples::row;

/// A row as a journal has it.
JournalledRow written(std::uint64_t index, std::uint64_t variant = 0) {
  return samples::journalled(row(index, variant));
}

constexpr JournalIdentity identity{.spec_hash = 0x1234567890abcdef, .physics_version = 7, .rows = 5000};
constexpr std::size_t head_size = 72;  // the header alone; the description of the sweep follows

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class JournalTest : public testing::Test {
 protected:
  samples::Directory directory;
  std::string table = directory.file("t.h5"), path = directory.file("t.h5.journal");
  const std::size_t header_size = size_without_records();  // description included

  void write(std::initializer_list<std::uint64_t> indices) {
    Journal journal(table, identity, true);
    for (const auto index : indices) journal.append(row(index));
  }
  std::size_t size_without_records() const {
    Journal journal(table, identity, true);
    const std::size_t size = bytes_of(path).size();
    journal.remove();
    return size;
  }
  std::size_t record_size() {
    write({0});
    return bytes_of(path).size() - header_size;
  }
};

TEST_F(JournalTest, KeepsEveryBitOfEveryMember) {
  {
    Journal journal(table, identity, false);
    EXPECT_TRUE(journal.recovered().empty());
    for (std::uint64_t i = 0; i < identity.rows; ++i) journal.append(row(identity.rows - 1 - i));
  }
  const Journal journal(table, identity, false);
  const std::vector<JournalledRow> rows = journal.recovered();
  ASSERT_EQ(rows.size(), identity.rows);
  EXPECT_EQ(journal.dropped(), 0u);
  for (std::uint64_t i = 0; i < identity.rows; ++i) ASSERT_EQ(bits(rows[i]), bits(written(i))) << i;
}

TEST_F(JournalTest, EqualRowsAreEqualBytesWhateverIsInTheirPadding) {
  std::string written[2];
  for (const int padding : {0, 1}) {
    alignas(Row) std::byte memory[sizeof(Row)];
    std::memset(memory, padding * 0xff, sizeof memory);
    Row* const padded = new (memory) Row;
    const Row wanted = row(3);
    padded->index = wanted.index;  // member by member, so that the padding stays
    Parameters& p = padded->parameters;
    const Parameters& q = wanted.parameters;
    p.v0 = q.v0, p.tc = q.tc, p.s0 = q.s0, p.sigma = q.sigma, p.epsilon = q.epsilon, p.d = q.d;
    p.steps_per_tc = q.steps_per_tc, p.tolerance = q.tolerance, p.N = q.N;
    p.method = q.method, p.wall = q.wall, p.integrator = q.integrator;
    Journal(table, identity, true).append(*padded);
    written[padding] = bytes_of(path);
  }
  EXPECT_EQ(written[0], written[1]);
}

/// A row of an attempt, whose results depend on the variant.
Row attempt_at(std::uint64_t index, std::int32_t attempt, Status status, std::uint64_t variant) {
  Row tried = row(index, variant);
  tried.timing.attempt = attempt;
  tried.result.status = status;
  return tried;
}

TEST_F(JournalTest, OfARowTheLastAttemptCountsAndOfItsCopiesOneThatWasNotCutShort) {
  const Row old = attempt_at(4, 1, Status::ok, 1), young = attempt_at(4, 2, Status::ok, 2);
  const Row cut = attempt_at(9, 1, Status::time_limit, 3), whole = attempt_at(9, 1, Status::ok, 4);
  const Row first = attempt_at(2, 1, Status::ok, 5), second = attempt_at(2, 1, Status::ok, 6);
  {
    Journal journal(table, identity, false);
    for (const Row& each : {young, old, whole, cut, first, second}) journal.append(each);
  }
  const Journal journal(table, identity, false);
  ASSERT_EQ(journal.recovered().size(), 3u);
  EXPECT_EQ(bits(journal.recovered()[0]), bits(samples::journalled(second)));
  EXPECT_EQ(bits(journal.recovered()[1]), bits(samples::journalled(young)));
  EXPECT_EQ(bits(journal.recovered()[2]), bits(samples::journalled(whole)));
}

TEST_F(JournalTest, GoesOnAfterATailTornAtAnyByte) {
  const std::size_t size = record_size();
  write({10, 11, 12});
  const std::string whole = bytes_of(path);
  ASSERT_EQ(whole.size(), header_size + 3 * size);
  for (std::size_t left = 0; left < size; ++left) {
    SCOPED_TRACE(left);
    put_bytes(path, whole.substr(0, header_size + 2 * size + left));
    {
      Journal journal(table, identity, false);
      ASSERT_EQ(journal.recovered().size(), 2u);
      EXPECT_EQ(bits(journal.recovered()[1]), bits(written(11)));
      EXPECT_EQ(journal.dropped(), left == 0 ? 0u : 1u);
      journal.append(row(12));
    }
    ASSERT_EQ(bytes_of(path), whole);
  }
}

TEST_F(JournalTest, CutsATailOfZeros) {  // what a crashed machine may leave
  write({10, 11, 12});
  const std::string whole = bytes_of(path);
  put_bytes(path, whole + std::string(100000, '\0'));
  EXPECT_EQ(Journal(table, identity, false).recovered().size(), 3u);
  EXPECT_EQ(bytes_of(path), whole);
}

#ifdef SIGMASWEEP_SANITIZED  // fifty times as slow
constexpr std::size_t next_bit = 11;
#else
constexpr std::size_t next_bit = 1;
#endif

TEST_F(JournalTest, AFlippedBitLosesItsRecordAndNoOther) {
  const std::size_t size = record_size();
  write({20, 21, 22, 23});
  const std::string whole = bytes_of(path);
  for (std::size_t bit = 8 * header_size; bit < 8 * whole.size(); bit += next_bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    put_bytes(path, damaged);
    const std::uint64_t lost = 20 + (bit / 8 - header_size) / size;
    const Journal journal(table, identity, false);
    ASSERT_EQ(journal.dropped(), 1u) << bit;
    const std::vector<JournalledRow> rows = journal.recovered();
    ASSERT_EQ(rows.size(), 3u) << bit;
    for (const JournalledRow& found : rows) {
      ASSERT_NE(found.row.index, lost) << bit;
      ASSERT_EQ(bits(found), bits(written(found.row.index))) << bit;
    }
  }
}

TEST_F(JournalTest, AppendsBehindADamagedRecord) {
  const std::size_t size = record_size();
  write({20, 21, 22});
  std::string damaged = bytes_of(path);
  damaged[header_size + size + 5] ^= 1;
  put_bytes(path, damaged);
  {
    Journal journal(table, identity, false);
    journal.append(row(21));
  }
  EXPECT_EQ(Journal(table, identity, false).recovered().size(), 3u);
}

TEST_F(JournalTest, ARecordIsGoodOnlyAtItsOwnPlace) {
  const std::size_t size = record_size();
  write({20, 21, 22});
  std::string swapped = bytes_of(path);
  std::swap_ranges(swapped.begin() + header_size, swapped.begin() + header_size + static_cast<long>(size),
                   swapped.begin() + header_size + static_cast<long>(size));
  put_bytes(path, swapped);
  const Journal journal(table, identity, false);
  ASSERT_EQ(journal.recovered().size(), 1u);
  EXPECT_EQ(journal.recovered()[0].row.index, 22u);
}

TEST_F(JournalTest, AFlippedBitInTheHeaderStopsEverything) {
  write({20, 21});
  const std::string whole = bytes_of(path);
  for (std::size_t bit = 0; bit < 8 * head_size; ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    put_bytes(path, damaged);
    ASSERT_THROW(Journal(table, identity, false), OutputError) << bit;
    ASSERT_EQ(bytes_of(path), damaged) << bit;
  }
}

TEST_F(JournalTest, AFlippedBitInTheDescriptionIsMendedAndLosesNoRow) {
  write({20, 21});
  const std::string whole = bytes_of(path);
  for (std::size_t bit = 8 * head_size; bit < 8 * header_size; bit += 7) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    put_bytes(path, damaged);
    ASSERT_EQ(Journal(table, identity, false).recovered().size(), 2u) << bit;
    ASSERT_EQ(bytes_of(path), whole) << bit;
  }
}

TEST_F(JournalTest, LeavesAForeignFileAlone) {
  for (const std::string& foreign : {std::string(), std::string("hello"), std::string(4096, 'x')}) {
    put_bytes(path, foreign);
    const std::string message = message_of<OutputError>([&] { Journal(table, identity, false); });
    EXPECT_TRUE(contains(message, path) && contains(message, "not a journal")) << message;
    EXPECT_TRUE(contains(message, "--fresh")) << message;
    EXPECT_EQ(bytes_of(path), foreign);
  }
  EXPECT_TRUE(Journal(table, identity, true).recovered().empty());
  EXPECT_TRUE(Journal(table, identity, false).recovered().empty());
}

TEST_F(JournalTest, LeavesADirectoryOfItsNameAlone) {
  std::filesystem::create_directory(path);
  EXPECT_THROW(Journal(table, identity, false), OutputError);
  EXPECT_THROW(Journal(table, identity, true), OutputError);
  EXPECT_TRUE(std::filesystem::is_directory(path));
  EXPECT_EQ(directory.names(), std::vector<std::string>{"t.h5.journal"});
}

TEST_F(JournalTest, LeavesAnotherSweepsJournalAlone) {
  write({1, 2, 3});
  const std::string before = bytes_of(path);
  JournalIdentity spec = identity, physics = identity, size = identity;
  ++spec.spec_hash;
  ++physics.physics_version;
  ++size.rows;
  const auto refused = [&](const JournalIdentity& other) {
    return message_of<OutputError>([&] { Journal(table, other, false); });
  };
  EXPECT_TRUE(contains(refused(spec), "another sweep spec"));
  EXPECT_TRUE(contains(refused(physics), "physics version 7, this program has 8"));
  EXPECT_TRUE(contains(refused(size), "5000 rows, this one has 5001"));
  EXPECT_TRUE(contains(refused(spec), "--fresh"));
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(Journal(table, identity, false).recovered().size(), 3u);
}

TEST_F(JournalTest, FreshStartsAgain) {
  write({1, 2, 3});
  EXPECT_TRUE(Journal(table, identity, true).recovered().empty());
  EXPECT_EQ(bytes_of(path).size(), header_size);
}

TEST_F(JournalTest, IsNotThereBeforeItBegins) {
  {
    Journal journal(table, identity, false);
    EXPECT_FALSE(journal.is_there());
  }
  EXPECT_TRUE(directory.names().empty());
  {
    Journal journal(table, identity, false);
    journal.begin(2, [](std::uint64_t k) { return row(3 + k); });
    EXPECT_TRUE(journal.is_there());
    journal.begin(1, [](std::uint64_t) { return row(5); });
  }
  const Journal journal(table, identity, false);
  EXPECT_TRUE(journal.is_there());
  ASSERT_EQ(journal.recovered().size(), 3u);
  for (std::uint64_t i = 0; i < 3; ++i) EXPECT_EQ(bits(journal.recovered()[i]), bits(written(3 + i)));
  EXPECT_EQ(journal.dropped(), 0u);
}

TEST_F(JournalTest, LeavesNothingBehindOnceRemoved) {
  {
    Journal journal(table, identity, false);
    journal.append(row(0));
    journal.sync();
    journal.remove();
    EXPECT_THROW(journal.append(row(1)), IoError);
  }
  EXPECT_TRUE(directory.names().empty());
}

TEST_F(JournalTest, CanBeMoved) {
  Journal journal(table, identity, false);
  journal.append(row(0));
  Journal moved = std::move(journal);
  moved.append(row(1));
  moved = Journal(directory.file("other.h5"), identity, false);
  EXPECT_EQ(Journal(table, identity, false).recovered().size(), 2u);
}

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

TEST_F(JournalTest, SaysWhereItCannotBeMade) {
  const std::string nowhere = directory.file("missing/t.h5");
  const std::string message = message_of<OutputError>([&] { Journal(nowhere, identity, false); });
  EXPECT_TRUE(contains(message, nowhere) && contains(message, "No such file or directory")) << message;
}

}  // namespace
}  // namespace sigmasweep
