#include "store/run_notes/run_notes.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "store/run_notes/contents.hpp"
#include "store/run_notes/look.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using namespace std::chrono_literals;
using samples::bytes_of;
using samples::put_bytes;

constexpr RunNotesIdentity identity{.spec_hash = 11, .rows = 1000, .run = 5};

class RunNotesTest : public testing::Test {
 protected:
  samples::Directory directory;
  std::string table = directory.file("t.h5"), path = directory.file("t.h5.running");

  /// A process with notes as rank `rank`, which has done `work` and then waits to be killed.
  pid_t start_rank(int rank, const std::function<void(RunNotes&)>& work) const {
    int ready[2];
    EXPECT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
      RunNotes notes(table, identity, rank);
      work(notes);
      if (write(ready[1], "", 1) != 1) _exit(1);
      for (;;) pause();
    }
    char byte;
    EXPECT_EQ(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    close(ready[1]);
    return child;
  }

  static void kill_it(pid_t child) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }

  static void hold(pid_t child) {
    kill(child, SIGSTOP);
    waitpid(child, nullptr, WUNTRACED);
  }

  /// Makes a rank one of another machine.
  void move_away(std::uint64_t rank) const {
    const File file(path, O_RDWR);
    const std::uint64_t page = notes::read(path).value().header.page_size;
    const std::byte other{'x'};
    ASSERT_EQ(write_at(file.fd(), std::span(&other, 1), page * (1 + rank) + offsetof(notes::RankPage, machine)), 0);
  }
};

TEST_F(RunNotesTest, ShowWhatEachRankDoes) {
  EXPECT_FALSE(look_at_run(table));
  begin_run_notes(table, identity, 2, false);
  const pid_t other = start_rank(1, [](RunNotes& notes) { notes.begin(7); });
  RunNotes mine(table, identity, 0);
  mine.begin(3);
  mine.end();
  mine.tell({.done = 12, .seconds = 4.0, .seconds_left = 9.0});
  const auto state = look_at_run(table);
  ASSERT_TRUE(state);
  EXPECT_TRUE(state->is_running);
  EXPECT_EQ(state->spec_hash, 11u);
  EXPECT_EQ(state->progress.done, 12u);
  EXPECT_EQ(state->progress.seconds, 4.0);
  EXPECT_EQ(state->progress.seconds_left, 9.0);
  ASSERT_EQ(state->ranks.size(), 2u);
  EXPECT_FALSE(state->ranks[0].row);
  EXPECT_EQ(state->ranks[1].row, 7u);
  EXPECT_GE(state->ranks[1].seconds.value(), 0.0);
  EXPECT_LT(state->ranks[1].seconds.value(), 60.0);
  char host[64] = "";
  gethostname(host, sizeof host - 1);
  EXPECT_EQ(state->ranks[0].host, host);
  kill_it(other);
}

TEST_F(RunNotesTest, AKilledRunIsSeenAtOnceOnItsMachine) {
  begin_run_notes(table, identity, 1, false);
  const pid_t rank = start_rank(0, [](RunNotes& notes) { notes.begin(42); });
  EXPECT_TRUE(look_at_run(table).value().is_running);
  kill(rank, SIGKILL);
  siginfo_t ended;
  waitid(P_PID, static_cast<id_t>(rank), &ended, WEXITED | WNOWAIT);  // nobody has asked for it yet
  const auto begin = std::chrono::steady_clock::now();
  const auto state = look_at_run(table, 1h);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 1min);
  EXPECT_FALSE(state->is_running);
  EXPECT_EQ(state->ranks.at(0).row, 42u);
  waitpid(rank, nullptr, 0);
}

TEST_F(RunNotesTest, AllRowsOfABatchAreSuspectedUntilOneIsAlone) {
  begin_run_notes(table, identity, 1, false);
  kill_it(start_rank(0, [](RunNotes& notes) { notes.begin(std::vector<std::uint64_t>{4, 9, 6}); }));
  EXPECT_EQ(look_at_run(table).value().ranks.at(0).row, 4u);
  EXPECT_EQ(begin_run_notes(table, identity, 1, false), (SuspicionByRow{{4, 1}, {6, 1}, {9, 1}}));
  kill_it(start_rank(0, [](RunNotes& notes) {
    notes.begin(std::vector<std::uint64_t>{1, 2, 3});
    notes.begin(9);
  }));
  EXPECT_EQ(begin_run_notes(table, identity, 1, false), (SuspicionByRow{{4, 1}, {6, 1}, {9, 3}}));
}

TEST_F(RunNotesTest, HeartbeatsTellOfARunOnAnotherMachine) {
  begin_run_notes(table, identity, 2, false);
  const pid_t rank = start_rank(0, [](RunNotes& notes) { notes.begin(1); });
  move_away(0);
  EXPECT_TRUE(look_at_run(table, 60s).value().is_running);
  hold(rank);
  EXPECT_FALSE(look_at_run(table, 2s).value().is_running);
  kill(rank, SIGCONT);
  EXPECT_TRUE(look_at_run(table, 60s).value().is_running);
  kill_it(rank);
  const auto state = look_at_run(table, 2s);
  EXPECT_FALSE(state->is_running);
  EXPECT_NE(state->known_by.find("no rank sent a heartbeat"), std::string::npos);
}

TEST_F(RunNotesTest, ARankThatIsHereWhileTheOthersAreNotTellsOfTheRun) {
  begin_run_notes(table, identity, 2, false);
  const pid_t there = start_rank(0, [](RunNotes&) {}), here = start_rank(1, [](RunNotes&) {});
  move_away(0);
  hold(there);
  EXPECT_TRUE(look_at_run(table, 0ms).value().is_running);
  kill_it(here);
  EXPECT_FALSE(look_at_run(table, 2s).value().is_running);
  kill_it(there);
}

TEST_F(RunNotesTest, LookingChangesNothing) {
  begin_run_notes(table, identity, 1, false);
  kill_it(start_rank(0, [](RunNotes& notes) { notes.begin(2); }));
  const std::string before = bytes_of(path);
  EXPECT_TRUE(look_at_run(table));
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(directory.names(), std::vector<std::string>{"t.h5.running"});
}

TEST_F(RunNotesTest, DeathsLeaveSuspicionThatAnOrderlyEndKeeps) {
  begin_run_notes(table, identity, 2, false);
  kill_it(start_rank(1, [](RunNotes& notes) { notes.begin(7); }));
  EXPECT_EQ(begin_run_notes(table, identity, 2, false), (SuspicionByRow{{7, 2}}));
  {
    RunNotes notes(table, identity, 0);
    notes.begin(8);
    notes.absolve();
    notes.begin(9);
  }
  end_run_notes(table, false);
  EXPECT_FALSE(look_at_run(table)) << "a run that has ended is not there to be looked at";
  EXPECT_EQ(begin_run_notes(table, identity, 3, false), (SuspicionByRow{{7, 2}}));
  end_run_notes(table, true);
  EXPECT_TRUE(directory.names().empty());
  EXPECT_TRUE(begin_run_notes(table, identity, 1, false).empty());
  end_run_notes(table, false);
  EXPECT_TRUE(directory.names().empty());
}

TEST_F(RunNotesTest, AForeignOrCutFileIsIgnored) {
  begin_run_notes(table, identity, 1, false);
  kill_it(start_rank(0, [](RunNotes& notes) { notes.begin(2); }));
  const std::string whole = bytes_of(path);
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, sizeof(notes::Header), whole.size() - 1}) {
    put_bytes(path, whole.substr(0, size));
    EXPECT_FALSE(look_at_run(table)) << size;
  }
  for (std::size_t byte = 0; byte < 56; ++byte) {  // the numbers that size something, and the magic one
    for (const int flip : {1, 0x80}) {
      std::string damaged = whole;
      damaged[byte] = static_cast<char>(damaged[byte] ^ flip);
      put_bytes(path, damaged);
      const auto state = look_at_run(table, 0ms);  // whatever it says
      if (state) {
        EXPECT_EQ(state->ranks.size(), 1u);
      }
    }
  }
}

}  // namespace
}  // namespace sigmasweep
