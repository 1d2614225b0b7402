#include "store/journal/journal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/journal_fixture.hpp"

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

TEST_F(JournalTest, SaysWhereItCannotBeMade) {
  const std::string nowhere = directory.file("missing/t.h5");
  const std::string message = message_of<OutputError>([&] { Journal(nowhere, identity, false); });
  EXPECT_TRUE(contains(message, nowhere) && contains(message, "No such file or directory")) << message;
}

}  // namespace
}  // namespace sigmasweep
