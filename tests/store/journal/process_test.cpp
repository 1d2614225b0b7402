// The journal between processes: kills, a second run on the same table, a disk that is full.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/journal.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using samples::bits;
using samples::bytes_of;
using samples::message_of;
using samples::row;

/// A row as a journal has it.
JournalledRow written(std::uint64_t index, std::uint64_t variant = 0) {
  return samples::journalled(row(index, variant));
}

constexpr JournalIdentity identity{.spec_hash = 42, .physics_version = 1, .rows = 1'000'000'000};

/// A child process that does `work` with the writing end of a pipe that this one reads from.
class Child {
 public:
  explicit Child(const std::function<void(int pipe)>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ == 0) {
      ::close(ends[0]);
      int code = 0;
      try {
        work(ends[1]);
      } catch (...) {
        code = 99;
      }
      _exit(code);
    }
    ::close(ends[1]);
    from_ = ends[0];
  }
  ~Child() {
    if (pid_ > 0) kill();
    ::close(from_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  pid_t pid() const { return pid_; }
  /// The next number that the child sent, or false when it is gone.
  bool read(std::uint64_t& number) { return ::read(from_, &number, sizeof number) == sizeof number; }
  void kill() {
    ::kill(pid_, SIGKILL);
    wait();
  }
  int wait() {
    int status = -1;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_ = -1;
  int from_ = -1;
};

void send(int pipe, std::uint64_t number) {
  if (::write(pipe, &number, sizeof number) != sizeof number) _exit(98);
}

class JournalProcessTest : public testing::Test {
 protected:
  samples::Directory directory;
  std::string table = directory.file("t.h5"), path = directory.file("t.h5.journal");
};

TEST_F(JournalProcessTest, EveryAppendedRowSurvivesSigkill) {
  std::uint64_t begun = 0;
  for (const std::uint64_t rows : {1, 2, 700, 1023, 1025, 5000}) {  // on both sides of a group commit
    SCOPED_TRACE(rows);
    Child child([&](int pipe) {
      Journal journal(table, identity, false);
      for (std::uint64_t i = begun;; ++i) {
        journal.append(row(i));
        send(pipe, i);
      }
    });
    std::uint64_t last = 0, more = 0;
    for (std::uint64_t i = 0; i < rows; ++i) ASSERT_TRUE(child.read(last));
    child.kill();
    while (child.read(more)) last = more;
    const Journal journal(table, identity, false);
    const std::vector<JournalledRow> rows_there = journal.recovered();
    ASSERT_GE(rows_there.size(), last + 1);
    ASSERT_LE(rows_there.size(), last + 2);  // one may have been written and not yet told
    EXPECT_LE(journal.dropped(), 1u);        // that one, torn where the write crossed a page
    for (std::uint64_t i = 0; i < rows_there.size(); ++i) ASSERT_EQ(bits(rows_there[i]), bits(written(i)));
    begun = rows_there.size();
  }
}

TEST_F(JournalProcessTest, RefusesASecondProcess) {
  Child child([&](int pipe) {
    Journal journal(table, identity, false);
    journal.append(row(0));
    send(pipe, 0);
    pause();
  });
  std::uint64_t ready = 0;
  ASSERT_TRUE(child.read(ready));
  const std::string before = bytes_of(path);
  for (const bool fresh : {false, true}) {
    const std::string message = message_of<OutputError>([&] { Journal(table, identity, fresh); });
    EXPECT_NE(message.find(table), std::string::npos) << message;
    EXPECT_NE(message.find("process " + std::to_string(child.pid()) + " "), std::string::npos) << message;
  }
  EXPECT_EQ(bytes_of(path), before);
  child.kill();
  EXPECT_EQ(Journal(table, identity, false).recovered().size(), 1u);  // the lock went with its owner
}

TEST_F(JournalProcessTest, ManyAtOnceAndOneGetsIt) {
  // All want the lock while its file is made and removed again and again: never two at a time.
  const auto hold = [&](int pipe) {
    for (int round = 0; round < 200; ++round) {
      try {
        Journal journal(table, identity, false);
        journal.append(row(0));
        const std::string mine = bytes_of(path);
        for (int i = 0; i < 20; ++i)
          if (bytes_of(path) != mine) _exit(97);
        journal.remove();
      } catch (const OutputError&) {
      }
    }
    send(pipe, 1);
  };
  Child a(hold), b(hold), c(hold);
  for (Child* child : {&a, &b, &c}) EXPECT_EQ(child->wait(), 0);
}

TEST_F(JournalProcessTest, AFullDiskIsAnErrorAndTheJournalStaysReadable) {
  std::uint64_t record = 0;
  {
    Journal journal(table, identity, true);
    const std::uint64_t empty = bytes_of(path).size();
    journal.append(row(0));
    record = bytes_of(path).size() - empty;
  }
  const std::uint64_t header = bytes_of(path).size() - record;
  for (const std::uint64_t room : {std::uint64_t{0}, std::uint64_t{1}, record - 1}) {  // left after 10 records
    SCOPED_TRACE(room);
    Child child([&](int pipe) {
      std::signal(SIGXFSZ, SIG_IGN);
      rlimit limit{};
      getrlimit(RLIMIT_FSIZE, &limit);
      limit.rlim_cur = header + 10 * record + room;
      Journal journal(table, identity, true);
      setrlimit(RLIMIT_FSIZE, &limit);
      std::uint64_t written = 0;
      try {
        for (;; ++written) journal.append(row(written));
      } catch (const IoError& error) {
        if (std::string(error.what()).find(path) == std::string::npos) _exit(96);
      }
      send(pipe, written);
      limit.rlim_cur = limit.rlim_max;  // somebody makes room: it goes on where it was
      setrlimit(RLIMIT_FSIZE, &limit);
      if (bytes_of(path).size() != header + 10 * record) _exit(95);
      journal.append(row(written));
    });
    std::uint64_t written = 0;
    ASSERT_TRUE(child.read(written));
    EXPECT_EQ(child.wait(), 0);
    EXPECT_EQ(written, 10u);
    const Journal journal(table, identity, false);
    ASSERT_EQ(journal.recovered().size(), 11u);
    EXPECT_EQ(journal.dropped(), 0u);
    for (std::uint64_t i = 0; i < 11; ++i) EXPECT_EQ(bits(journal.recovered()[i]), bits(samples::journalled(row(i))));
  }
}

}  // namespace
}  // namespace sigmasweep
