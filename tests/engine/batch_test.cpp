#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "base/thread_clock.hpp"
#include "engine/compute_batch.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

constexpr RunNotesIdentity identity{.spec_hash = 1, .rows = 1000, .run = 2};
constexpr const char* spec = R"(
[sweep]
integrator = ["verlet", "exact"]
v0 = 0.1
tc = 1e-5
epsilon = { from = 0.5, to = 0.9, count = 100 }
N = 3
sigma = [0.5, 2.0]
)";

class Batch : public testing::Test {
 protected:
  Batch() {
    begin_run_notes(directory_.file("t.h5"), identity, 1, true);
    notes_.emplace(directory_.file("t.h5"), identity, 0);
  }
  std::vector<ScheduledTask> tasks(double predicted_seconds) const {
    std::vector<ScheduledTask> tasks;
    for (std::uint64_t row = 0; row < sweep_.size(); ++row) tasks.push_back({row, predicted_seconds});
    return tasks;
  }
  BatchComputer computer(std::set<std::uint64_t> alone = {}) {
    return {0, {}, std::move(alone), *notes_, [this](std::uint64_t row) { return sweep_.at(row); }};
  }

  samples::Directory directory_;
  const Sweep sweep_ = Sweep::parse(spec, "spec");
  std::optional<RunNotes> notes_;
};

TEST_F(Batch, HasManyCheapRowsAndFewLongOnes) {
  const BatchComputer computer = this->computer();
  EXPECT_GE(computer.size(tasks(1e-6)), 64u);
  EXPECT_LE(computer.size(tasks(1e-6)), 256u);
  EXPECT_EQ(computer.size(tasks(1.0)), 1u);
  EXPECT_EQ(computer.size(tasks(3e-3)), 3u);  // a stop waits for 10 ms at most
}

TEST_F(Batch, RowsOfWhichAProcessMayHaveDiedAreAlone) {
  const BatchComputer computer = this->computer({2, 3});
  const std::vector<ScheduledTask> all = tasks(1e-6);
  const std::span left(all);
  EXPECT_EQ(computer.size(left), 2u);
  EXPECT_EQ(computer.size(left.subspan(2)), 1u);
  EXPECT_EQ(computer.size(left.subspan(3)), 1u);
  EXPECT_GE(computer.size(left.subspan(4)), 64u);
}

TEST_F(Batch, HasTheBitsOfOneByOneAndItsRowsShareTheTime) {
  BatchComputer computer = this->computer();
  std::vector<ScheduledTask> all = tasks(1e-6);
  std::vector<Row> answers;
  const double start = thread_seconds();
  while (answers.size() < all.size()) {
    const auto left = std::span(all).subspan(answers.size());
    computer.compute(
        left.first(computer.size(left)), [] { return false; }, answers);
  }
  const double needed = thread_seconds() - start;
  double sum = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(answers[i].index, all[i].row);
    const SimulationResult alone = simulate(sweep_.at(all[i].row));
    EXPECT_EQ(std::memcmp(&alone, &answers[i].result, offsetof(SimulationResult, status)), 0) << i;
    EXPECT_EQ(alone.status, answers[i].result.status);
    EXPECT_GT(answers[i].timing.run_time, 0.0);
    sum += answers[i].timing.run_time;
  }
  EXPECT_LE(sum, needed * (1.0 + 1e-12));  // rounding of a sum
  EXPECT_GE(sum, 0.5 * needed);            // the rest is choosing batches and allocating
}

/// Rows that drop out of a batch, as their tolerance is out of reach, take a thousand times what is predicted.
class SlowBatch : public Batch {
 protected:
  SlowBatch() {
    for (std::uint64_t row = 0; row < slow_.size(); ++row) tasks_.push_back({row, 1e-5});
  }
  BatchComputer computer() {
    return {0, {}, {}, *notes_, [this](std::uint64_t row) { return slow_.at(row); }};
  }

  const Sweep slow_ = Sweep::parse(
      "[sweep]\nv0 = 0.1\ntc = 1e-5\nN = 20\nepsilon = { from = 0.6, to = 0.601, count = 200 }\nsigma = 30.0\n",
      "spec");
  std::vector<ScheduledTask> tasks_;
};

TEST_F(SlowBatch, RowsThatDropOutAreBoundedAndTimedAlone) {
  const std::vector<ScheduledTask>& slow = tasks_;
  BatchComputer computer = this->computer();
  ASSERT_EQ(computer.size(slow), slow.size());
  std::vector<Row> answers;
  const double start = thread_seconds();
  computer.compute(
      slow, [] { return false; }, answers);
  ASSERT_GE(answers.size(), 1u);
  EXPECT_LT(answers.size(), slow.size());  // the others would take many seconds: they are put back
  double sum = 0.0;
  for (const Row& answer : answers) sum += answer.timing.run_time;
  EXPECT_LE(sum, thread_seconds() - start);
}

TEST_F(SlowBatch, StopsBetweenAndWithinRowsThatDropOut) {
  std::vector<Row> answers;
  computer().compute(
      tasks_, [] { return true; }, answers);
  EXPECT_LE(answers.size(), 1u);
}

}  // namespace
}  // namespace sigmasweep
