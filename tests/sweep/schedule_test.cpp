#include "sweep/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

using namespace sigmasweep;

namespace {

using Tasks = std::vector<ScheduledTask>;

/// Costs over five decades.
Tasks random_tasks(std::size_t count, std::uint32_t seed) {
  std::mt19937_64 generator(seed);
  Tasks tasks;
  for (std::size_t i = 0; i < count; ++i)
    tasks.push_back({3 * i + 1, std::pow(10.0, -5.0 + 5.0 * static_cast<double>(generator() >> 11) * 0x1p-53)});
  return tasks;
}

/// Rows 0, 1, ... with these predictions.
Tasks tasks_of(const std::vector<double>& seconds) {
  Tasks tasks;
  for (const double prediction : seconds) tasks.push_back({tasks.size(), prediction});
  return tasks;
}

std::vector<std::uint64_t> rows_of(std::span<const ScheduledTask> tasks) {
  std::vector<std::uint64_t> rows;
  for (const ScheduledTask& task : tasks) rows.push_back(task.row);
  return rows;
}

std::vector<std::vector<std::uint64_t>> chunks(Schedule& schedule) {
  std::vector<std::vector<std::uint64_t>> all;
  for (auto chunk = schedule.next(); !chunk.empty(); chunk = schedule.next()) all.push_back(rows_of(chunk));
  return all;
}

}  // namespace

TEST(Schedule, HandsOutEachRowOnce) {
  for (const std::size_t count : {0u, 1u, 2u, 1000u, 20000u}) {
    const Tasks tasks = random_tasks(count, 11);
    Schedule schedule(tasks, 4);
    std::multiset<std::uint64_t> seen;
    for (const auto& chunk : chunks(schedule)) seen.insert(chunk.begin(), chunk.end());
    const auto rows = rows_of(tasks);
    EXPECT_EQ(seen, std::multiset<std::uint64_t>(rows.begin(), rows.end()));
    EXPECT_TRUE(schedule.next().empty());
  }
}

TEST(Schedule, LargestFirstTiesByRow) {
  Schedule schedule({{5, 1.0}, {2, 3.0}, {9, 1.0}, {4, 3.0}}, 2);
  EXPECT_EQ(chunks(schedule), (std::vector<std::vector<std::uint64_t>>{{2}, {4}, {5}, {9}}));
}

TEST(Schedule, DoesNotDependOnTheOrderOfItsInput) {
  Tasks tasks = random_tasks(500, 12);
  Schedule one(tasks, 3);
  std::ranges::reverse(tasks);
  Schedule other(tasks, 3);
  EXPECT_EQ(chunks(one), chunks(other));
}

TEST(Schedule, ChunksKeepTheirLimitsAndShrink) {
  const double min_chunk = 2e-3, max_chunk = 0.1;
  const Tasks tasks = tasks_of(std::vector<double>(100000, 1e-5));  // 1 s in all
  Schedule schedule(tasks, 2, min_chunk, max_chunk);
  Schedule unlimited(tasks, 4, min_chunk, 10.0);
  EXPECT_NEAR(static_cast<double>(chunks(unlimited).front().size()), 100000 / 8, 1);  // half of a rank's share
  const auto all = chunks(schedule);
  EXPECT_NEAR(static_cast<double>(all.front().size()), 10000, 1);  // max_chunk, below 1 s/(2 ranks)
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LE(all[i].size(), all[i - 1].size());
    if (i + 1 < all.size()) {
      EXPECT_GE(all[i].size(), 199u);  // min_chunk, one row of rounding
    }
  }
}

TEST(Schedule, MakespanLiesBetweenItsBounds) {
  for (const std::uint32_t seed : {1u, 2u, 3u})
    for (const int ranks : {1, 2, 7, 64}) {
      const Schedule schedule(random_tasks(3000, seed), ranks);
      const double rounding = 1e-12 * schedule.total_seconds();  // 3000 additions of relative error 1e-16
      EXPECT_GE(schedule.predicted_makespan(), schedule.lower_bound_seconds() - rounding);
      EXPECT_LE(schedule.predicted_makespan(), schedule.total_seconds() + rounding);
      if (ranks == 1) {
        EXPECT_NEAR(schedule.predicted_makespan(), schedule.total_seconds(), rounding);
      }
    }
}

TEST(Schedule, IsNearlyOptimal) {
  const Schedule schedule(random_tasks(5000, 4), 8);
  // List scheduling ends at most one chunk after the lower bound; the last chunks are about a millisecond.
  EXPECT_LE(schedule.predicted_makespan(), schedule.lower_bound_seconds() + 3e-3);
}

TEST(Schedule, KnowsSumAndLongest) {
  const Schedule schedule(tasks_of({1.0, 4.0, 1.0}), 3);
  EXPECT_EQ(schedule.total_seconds(), 6.0);
  EXPECT_EQ(schedule.longest_seconds(), 4.0);
  EXPECT_EQ(schedule.lower_bound_seconds(), 4.0);
  EXPECT_EQ(schedule.predicted_makespan(), 4.0);
  const Schedule empty({}, 3);
  EXPECT_EQ(empty.predicted_makespan(), 0.0);
}

TEST(Schedule, RefusesNonsense) {
  EXPECT_THROW(Schedule({{0, 1.0}}, 0), std::invalid_argument);
  for (const double seconds : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(Schedule({{0, seconds}}, 1), std::invalid_argument) << seconds;
}

TEST(Schedule, PassesOverWhatIsTooLong) {
  Schedule schedule(tasks_of({8.0, 4.0, 2.0, 1.0}), 1);
  const auto next = [&](double most) { return rows_of(schedule.next(most)); };
  using Rows = std::vector<std::uint64_t>;
  EXPECT_EQ(next(0.5), Rows{});
  EXPECT_EQ(next(-1.0), Rows{});
  EXPECT_EQ(next(3.0), Rows{2});
  EXPECT_EQ(next(3.0), Rows{3});
  EXPECT_EQ(next(3.0), Rows{});
  EXPECT_EQ(next(5.0), Rows{1});  // looked at again
  EXPECT_EQ(next(5.0), Rows{});
  EXPECT_EQ(next(9.0), Rows{0});
  EXPECT_EQ(next(9.0), Rows{});
}

TEST(Schedule, GivesTheShortestRowThatIsLeft) {
  Schedule schedule(tasks_of({8.0, 4.0, 2.0, 1.0}), 1);
  using Rows = std::vector<std::uint64_t>;
  EXPECT_EQ(rows_of(schedule.shortest()), Rows{3});
  EXPECT_EQ(rows_of(schedule.next(1.0)), Rows{});  // all are passed over
  EXPECT_EQ(rows_of(schedule.shortest()), Rows{2});
  EXPECT_EQ(rows_of(schedule.next(4.0)), Rows{1});
  EXPECT_EQ(rows_of(schedule.shortest()), Rows{0});
  EXPECT_EQ(rows_of(schedule.shortest()), Rows{});
  EXPECT_EQ(rows_of(schedule.next()), Rows{});
}

TEST(Schedule, HandsOutEachRowOnceWithinAnyLimits) {
  const Tasks tasks = random_tasks(5000, 13);
  Schedule schedule(tasks, 4);
  std::mt19937_64 generator(17);
  std::set<std::uint64_t> seen;
  for (int tries = 0; seen.size() < tasks.size() && tries < 200000; ++tries) {
    const double most = std::pow(10.0, -5.0 + 5.1 * static_cast<double>(generator() >> 11) * 0x1p-53);
    double sum = 0.0;
    for (const ScheduledTask& task : schedule.next(most)) {
      EXPECT_TRUE(seen.insert(task.row).second);
      EXPECT_EQ(task, tasks[(task.row - 1) / 3]);
      sum += task.predicted_seconds;
    }
    EXPECT_LE(sum, most * (1.0 + 1e-12));  // rounding of the sum
  }
  EXPECT_EQ(seen.size(), tasks.size());
  EXPECT_TRUE(schedule.next().empty());
}
