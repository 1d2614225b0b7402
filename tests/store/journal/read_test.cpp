#include "store/journal/read.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "store/journal/journal.hpp"
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

constexpr JournalIdentity identity{.spec_hash = 3, .physics_version = physics_version, .rows = 100'000};

class ReadJournal : public testing::Test {
 protected:
  samples::Directory directory;
  std::string table = directory.file("t.h5"), path = directory.file("t.h5.journal");

  Journal begin(const TableInfo& info = {}) const { return Journal(table, identity, true, {}, info); }
};

TEST_F(ReadJournal, TellsTheSweepOfTheJournal) {
  TableInfo info;
  info.title = "\u03c3 \"quoted\"\n\t\x01";
  info.spec_text = "# \u00e9\n[sweep]\n";
  info.host = "node7";
  info.start = "now";
  info.spec_hash = 0xfedcba9876543210;
  info.ranks = 64;
  info.slice = {3, 8};
  begin(info).append(row(3));
  const auto found = read_journal(table);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->info.title, info.title);
  EXPECT_EQ(found->info.spec_text, info.spec_text);
  EXPECT_EQ(found->info.host, info.host);
  EXPECT_EQ(found->info.start, info.start);
  EXPECT_EQ(found->info.spec_hash, info.spec_hash);
  EXPECT_EQ(found->info.ranks, 64);
  EXPECT_EQ(found->info.slice, info.slice);
  EXPECT_EQ(found->info.physics_version, physics_version);
  EXPECT_FALSE(found->info.build.empty());
  EXPECT_EQ(found->total, 12'500u);  // an eighth
}

TEST_F(ReadJournal, IsNotThereWithoutAFile) {
  EXPECT_FALSE(read_journal(table));
  EXPECT_FALSE(read_journal(table + "/t.h5"));
}

TEST_F(ReadJournal, PassesOverATailTornAtAnyByteAndChangesNothing) {
  {
    Journal journal = begin();
    for (const std::uint64_t index : {10, 11, 12}) journal.append(row(index));
  }
  const std::string whole = bytes_of(path);
  const std::size_t size = (whole.size() - 72 - 8) / 3;  // more than a record
  for (std::size_t cut = 0; cut < size; ++cut) {
    const std::string torn = whole.substr(0, whole.size() - cut);
    put_bytes(path, torn);
    const auto found = read_journal(table);
    ASSERT_TRUE(found);
    ASSERT_GE(found->rows.size(), cut == 0 ? 3u : 1u) << cut;
    for (const JournalledRow& r : found->rows) ASSERT_EQ(bits(r), bits(written(r.row.index)));
    ASSERT_EQ(bytes_of(path), torn);
  }
}

TEST_F(ReadJournal, ReadsWhileAnotherProcessAppends) {
  begin();
  const pid_t writer = fork();
  if (writer == 0) {
    Journal journal(table, identity, false);
    for (std::uint64_t i = 0; i < 20'000; ++i) journal.append(row(i));
    _exit(0);
  }
  std::size_t before = 0, looks = 0;
  int status = 0;
  while (waitpid(writer, &status, WNOHANG) == 0) {
    const auto found = read_journal(table);
    ASSERT_TRUE(found);
    ASSERT_GE(found->rows.size(), before);
    before = found->rows.size();
    for (std::size_t k = 0; k < before; ++k) ASSERT_EQ(found->rows[k].row.index, k);
    ++looks;
  }
  EXPECT_EQ(status, 0);
  EXPECT_GT(looks, 1u);
  EXPECT_EQ(read_journal(table).value().rows.size(), 20'000u);
}

TEST_F(ReadJournal, RefusesWhatIsNoJournal) {
  for (const std::string& foreign : {std::string(), std::string("hello"), std::string(4096, 'x')}) {
    put_bytes(path, foreign);
    EXPECT_NE(message_of<IoError>([&] { read_journal(table); }).find("not a journal"), std::string::npos);
  }
  std::filesystem::remove(path);
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_THROW(read_journal(table), IoError);  // and does not wait for a writer
}

TEST_F(ReadJournal, RefusesOtherPhysicsAndADamagedDescription) {
  { Journal(table, {.spec_hash = 3, .physics_version = physics_version + 1, .rows = 9}, true); }
  EXPECT_NE(message_of<IoError>([&] { read_journal(table); }).find("physics version"), std::string::npos);
  { begin(); }
  std::string damaged = bytes_of(path);
  damaged[80] ^= 1;
  put_bytes(path, damaged);
  EXPECT_NE(message_of<IoError>([&] { read_journal(table); }).find("describes the sweep"), std::string::npos);
  { Journal(table, identity, false); }  // mends it
  EXPECT_TRUE(read_journal(table));
}

}  // namespace
}  // namespace sigmasweep
