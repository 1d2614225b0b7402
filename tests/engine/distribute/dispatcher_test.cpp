// The dispatcher with workers that are simulated: their clock jumps from event to event.
#include "engine/distribute/dispatcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <sstream>

#include "engine/distribute/task_queue.hpp"

namespace sigmasweep {
namespace {

constexpr double latency = 1e-3;  // s, of each message: the longest sleep of a rank that waits

/// A run of tasks whose true times are known. `shares` is false where ranks keep what they have got.
class Replay {
 public:
  Replay(const std::vector<ScheduledTask>& tasks, std::vector<double> seconds, int ranks, bool shares = true)
      : schedule_(tasks, ranks),
        dispatcher_(schedule_, ranks),
        seconds_(std::move(seconds)),
        ranks_(static_cast<std::size_t>(ranks)),
        shares_(shares) {}

  /// The time when the last answer has come, s.
  double makespan() {
    for (int rank = 0; rank < static_cast<int>(ranks_.size()); ++rank) supply(rank);
    share();
    while (!events_.empty()) {
      const auto next = events_.begin();
      now_ = next->first;
      const std::function<void()> act = std::move(next->second);
      events_.erase(next);
      act();
    }
    return now_;
  }
  /// How often each row was computed.
  const std::map<std::uint64_t, int>& computed() const { return computed_; }

 private:
  struct Rank {
    TaskQueue queue{sizeof(std::uint64_t)};
    bool is_busy = false;
    int undelivered = 0;
  };

  void in(double seconds, std::function<void()> act) { events_.emplace(now_ + seconds, std::move(act)); }

  void supply(int rank) {
    for (auto tasks = dispatcher_.next(rank); !tasks.empty(); tasks = dispatcher_.next(rank)) {
      wire::Bytes bytes;
      for (const ScheduledTask& task : tasks) wire::append(bytes, task.row);
      in(latency, [this, rank, bytes] {
        ranks_[rank].queue.add(bytes);
        if (!ranks_[rank].is_busy) compute(rank);
      });
    }
  }

  void compute(int rank) {
    Rank& its = ranks_[rank];
    const wire::Bytes bytes = its.queue.take(1);
    std::span<const std::byte> task(bytes);
    std::uint64_t row = 0;
    wire::take(task, row);
    its.is_busy = true;
    ++computed_[row];
    in(seconds_[row], [this, rank] {
      Rank& done = ranks_[rank];
      done.is_busy = false;
      ++done.undelivered;
      if (done.queue.is_between_chunks()) deliver(rank);
      if (!done.queue.empty()) compute(rank);
    });
  }

  void deliver(int rank) {
    in(latency, [this, rank, answers = std::exchange(ranks_[rank].undelivered, 0)] {
      for (int i = 0; i < answers; ++i) EXPECT_TRUE(dispatcher_.answered(rank));
      supply(rank);
      share();
    });
  }

  void share() {
    const int ranks = static_cast<int>(ranks_.size());
    int idle = 0;
    for (int rank = 0; rank < ranks; ++rank) idle += dispatcher_.is_idle(rank);
    while (shares_ && dispatcher_.asked() < idle) {
      const auto asked = dispatcher_.next_to_give_back();
      if (!asked) return;
      in(latency, [this, rank = *asked] {
        in(latency, [this, rank, given = ranks_[rank].queue.give_half()] {
          dispatcher_.given_back(rank, given);
          for (int other = 0; other < static_cast<int>(ranks_.size()); ++other)
            if (dispatcher_.is_idle(other)) supply(other);
          supply(rank);
          share();
        });
      });
    }
  }

  Schedule schedule_;
  Dispatcher dispatcher_;
  std::vector<double> seconds_;  // by row
  std::vector<Rank> ranks_;
  bool shares_;
  double now_ = 0.0;
  std::multimap<double, std::function<void()>> events_;
  std::map<std::uint64_t, int> computed_;
};

struct Recorded {
  std::vector<ScheduledTask> tasks;
  std::vector<double> seconds;  // by row

  double bound(int ranks) const {
    return std::max(std::accumulate(seconds.begin(), seconds.end(), 0.0) / ranks, *std::ranges::max_element(seconds));
  }
};

Recorded recorded(const std::string& path) {
  constexpr double unit = 1e-7;  // s
  Recorded found;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream numbers(line);
    double predicted = 0.0, needed = 0.0;
    numbers >> predicted;
    while (numbers >> needed) {
      found.tasks.push_back({found.tasks.size(), predicted * unit});
      found.seconds.push_back(needed * unit);
    }
  }
  return found;
}

TEST(Dispatcher, GivingBackMakesUpForPredictionsThatAreWrongAThousandfold) {
  const Recorded collapse = recorded(SIGMASWEEP_COLLAPSE_TIMES);
  ASSERT_EQ(collapse.tasks.size(), 15200u);
  struct Case {
    int ranks;
    double with, without;  ///< makespan over its lower bound: at most, at least
  };
  for (const auto [ranks, with, without] :
       {Case{2, 1.01, 1.0}, Case{8, 1.05, 1.2}, Case{32, 1.2, 2.0}, Case{128, 1.6, 8.0}}) {
    SCOPED_TRACE(ranks);
    Replay sharing(collapse.tasks, collapse.seconds, ranks), keeping(collapse.tasks, collapse.seconds, ranks, false);
    const double shared = sharing.makespan() / collapse.bound(ranks), kept = keeping.makespan() / collapse.bound(ranks);
    RecordProperty(std::to_string(ranks) + "_ranks", std::to_string(shared));
    std::cout << ranks << " ranks: " << shared << " times the bound, without giving back " << kept << '\n';
    EXPECT_LT(shared, with);
    EXPECT_GT(kept, without);
    EXPECT_EQ(sharing.computed().size(), collapse.tasks.size());
    for (const auto& [row, times] : sharing.computed()) EXPECT_EQ(times, 1) << row;
  }
}

TEST(Dispatcher, ARankBehindALongTaskKeepsNothingThatOthersCouldDo) {
  // Ten tasks are predicted to be equally short; the first takes a second.
  std::vector<ScheduledTask> tasks;
  for (std::uint64_t row = 0; row < 10; ++row) tasks.push_back({row, 1e-6});
  std::vector<double> seconds(10, 0.02);
  seconds[0] = 1.0;
  EXPECT_LT(Replay(tasks, seconds, 2).makespan(), 1.0 + 10 * latency);
  EXPECT_GT(Replay(tasks, seconds, 2, false).makespan(), 1.1);
}

TEST(Dispatcher, EachRowIsComputedOnceWhateverTheTimes) {
  const unsigned seed = std::random_device{}();
  RecordProperty("seed", std::to_string(seed));
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::minstd_rand random(seed);
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t rows = 1 + random() % 600;
    std::vector<ScheduledTask> tasks;
    std::vector<double> seconds;
    for (std::uint64_t row = 0; row < rows; ++row) {
      tasks.push_back({row, 1e-6 * static_cast<double>(1 + random() % 1000)});
      seconds.push_back(1e-6 * static_cast<double>(random() % 10 == 0 ? random() % 8000 : random() % 100));
    }
    Replay replay(tasks, seconds, static_cast<int>(2 + random() % 6));
    replay.makespan();
    ASSERT_EQ(replay.computed().size(), rows);
    for (const auto& [row, times] : replay.computed()) ASSERT_EQ(times, 1) << row;
  }
}

TEST(Dispatcher, ARankThatIsAskedGetsNothingBeforeItHasAnswered) {
  Schedule schedule({{0, 1e-6}, {1, 1e-6}, {2, 1e-6}, {3, 1e-6}}, 2, 2e-6, 2e-6);
  Dispatcher dispatcher(schedule, 2);
  const auto first = dispatcher.next(0);
  ASSERT_GE(first.size(), 2u);
  EXPECT_EQ(dispatcher.next_to_give_back(), 0);
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_TRUE(dispatcher.answered(0));
  EXPECT_TRUE(dispatcher.next(0).empty());
  EXPECT_TRUE(dispatcher.next_overdue(0, 0.0).empty());
  dispatcher.given_back(0, 0);
  EXPECT_FALSE(dispatcher.next(0).empty());
}

TEST(Dispatcher, TasksThatAreGivenBackAreHandedOutWithinTheTimeThatIsLeft) {
  double left = 10.0;
  Schedule schedule({{0, 4.0}, {1, 3.0}, {2, 1.0}}, 1, 8.0, 8.0);
  Dispatcher dispatcher(schedule, 2, [&] { return left; });
  EXPECT_EQ(dispatcher.next(0).size(), 3u);
  EXPECT_TRUE(dispatcher.next(1).empty());
  EXPECT_EQ(dispatcher.next_to_give_back(), 0);
  EXPECT_FALSE(dispatcher.next_to_give_back());  // it was asked
  dispatcher.given_back(0, 2);
  left = 2.0;
  EXPECT_EQ(dispatcher.next(1), (Dispatcher::Tasks{{2, 1.0}}));
  EXPECT_TRUE(dispatcher.answered(0));
  EXPECT_TRUE(dispatcher.answered(1));
  EXPECT_TRUE(dispatcher.next(0).empty());
  EXPECT_TRUE(dispatcher.out().all_are_back());
}

TEST(Dispatcher, RefusesWhatARankCannotGiveBack) {
  Schedule schedule({{0, 1.0}, {1, 1.0}}, 1, 8.0, 8.0);
  Dispatcher dispatcher(schedule, 1);
  dispatcher.next(0);
  EXPECT_THROW(dispatcher.given_back(0, 0), wire::BadMessage);  // it was not asked
  EXPECT_EQ(dispatcher.next_to_give_back(), 0);
  EXPECT_THROW(dispatcher.given_back(0, 3), wire::BadMessage);
}

TEST(TasksOut, OfATaskThatIsOutTwiceAndGivenBackOneIsLeft) {
  TasksOut out(3);
  out.hand_out(0, {0, 1e-9});
  out.hand_out(0, {1, 1e-9});
  for (const ScheduledTask& task : out.take_overdue(-1.0)) out.hand_out(1, task);
  EXPECT_EQ(out.count(1), 2u);
  EXPECT_TRUE(out.given_back(0, 1).empty());  // rank 1 has row 1 alone now
  EXPECT_TRUE(out.answered(1));               // row 0
  EXPECT_FALSE(out.answered(0));
  EXPECT_FALSE(out.all_are_back());
  EXPECT_TRUE(out.answered(1));
  EXPECT_TRUE(out.all_are_back());
}

TEST(TasksOut, ACopyThatIsOverdueIsCopiedAgain) {
  TasksOut out(3);
  out.hand_out(0, {0, 1e-9});
  for (const ScheduledTask& task : out.take_overdue(-1.0)) out.hand_out(1, task);
  EXPECT_TRUE(out.take_overdue(3600.0).empty());
  for (const ScheduledTask& task : out.take_overdue(-1.0)) out.hand_out(2, task);
  EXPECT_EQ(out.count(2), 1u);
  EXPECT_TRUE(out.given_back(1, 1).empty());  // two others have it
  EXPECT_FALSE(out.all_are_back());
  EXPECT_TRUE(out.answered(2));
  EXPECT_TRUE(out.all_are_back());
  EXPECT_FALSE(out.answered(0));
}

}  // namespace
}  // namespace sigmasweep
