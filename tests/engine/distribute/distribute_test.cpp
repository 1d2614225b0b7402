// The manager and the workers, at every number of ranks (one included) that CTest starts this with. Computing is
// sleeping here, so that ranks beyond the cores do not disturb the order of things.
#include <gtest/gtest.h>
#include <mpi.h>

#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "engine/distribute/distribute.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep {
namespace {

using std::chrono::microseconds;

const World& world() {
  static int argc = 0;
  static char** argv = nullptr;
  static const World world(argc, argv);
  return world;
}

long sum_over_ranks(long mine) {
  long sum = 0;
  EXPECT_EQ(MPI_Allreduce(&mine, &sum, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD), MPI_SUCCESS);
  return sum;
}

/// A task of some hundred bytes.
struct SweepTask {
  std::uint64_t index = 0;
  double predicted_seconds = 0.0;
  Parameters parameters;
};

/// Tuples whose every double is odd in some way: denormal, negative zero, the last bit set.
Parameters tuple(std::uint64_t row) {
  Parameters p;
  p.v0 = std::bit_cast<double>(row + 1);
  p.tc = row % 2 ? -0.0 : std::nextafter(1e-5, 1.0);
  p.s0 = std::bit_cast<double>(0x7ff4000000000000u + row);  // a signalling NaN with a payload
  p.N = static_cast<std::int64_t>(row);
  return p;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// A job that counts. `pause` is how long computing a row takes.
struct PreparedRun {
  explicit PreparedRun(std::uint64_t rows, double predicted_seconds = 1e-4) : predicted(predicted_seconds) {
    std::vector<ScheduledTask> all;
    for (std::uint64_t row = 0; row < rows; ++row) all.push_back({row, predicted_seconds});
    schedule.emplace(all, world().size());
    job.task = [](std::uint64_t row, double seconds) { return SweepTask{row, seconds, tuple(row)}; };
    job.compute = [this](const SweepTask& t, const auto&) {
      ++computed;
      std::this_thread::sleep_for(pause(t.index));
      Row row;
      row.index = t.index;
      row.parameters = t.parameters;
      row.result.eps_eff = t.parameters.s0;
      row.timing.rank = rank;
      row.timing.predicted_time = t.predicted_seconds;
      return row;
    };
    job.finished = [this](std::span<const Row> rows_in) {
      if (came.empty()) computed_at_first = computed;
      for (const Row& row : rows_in) take(row);
    };
    job.stop = [] { return false; };
  }

  void take(const Row& row) {
    ++came[row.index];
    ++rows_of[row.timing.rank];
    intact = intact && same_bits(row.parameters.v0, tuple(row.index).v0) &&
             same_bits(row.parameters.tc, tuple(row.index).tc) && same_bits(row.parameters.s0, tuple(row.index).s0) &&
             same_bits(row.result.eps_eff, tuple(row.index).s0) && same_bits(row.timing.predicted_time, predicted) &&
             row.parameters.N == tuple(row.index).N;
  }

  void run() { distribute(world(), world().is_manager() ? &*schedule : nullptr, job); }

  /// On the manager: rows 0..n-1, each once and unchanged.
  void expect_all(std::uint64_t n) const {
    if (!world().is_manager()) {
      EXPECT_TRUE(came.empty());
      return;
    }
    ASSERT_EQ(came.size(), n);
    for (const auto& [row, times] : came) EXPECT_EQ(times, 1) << row;
    EXPECT_TRUE(intact);
    if (n > 0) {
      EXPECT_EQ(came.rbegin()->first, n - 1);
    }
  }

  std::function<microseconds(std::uint64_t)> pause = [](std::uint64_t) { return microseconds(0); };
  std::optional<Schedule> schedule;
  Job<SweepTask, Row> job;
  const double predicted;
  const int rank = world().rank();
  std::atomic<long> computed = 0;
  long computed_at_first = 0;
  std::map<std::uint64_t, int> came;
  std::map<int, int> rows_of;  // by rank
  bool intact = true;
};

TEST(Distribute, EachRowComesBackOnceWhateverTheTimes) {
  const auto seed = static_cast<unsigned>(world().broadcast(std::int64_t{std::random_device{}()}));
  RecordProperty("seed", static_cast<int>(seed));
  SCOPED_TRACE("seed " + std::to_string(seed));
  PreparedRun trial(600);
  trial.pause = [seed](std::uint64_t row) {
    std::minstd_rand random(seed + static_cast<unsigned>(row));
    random.discard(3);
    return microseconds(random() % 10 == 0 ? random() % 8000 : random() % 100);
  };
  trial.run();
  trial.expect_all(600);
  EXPECT_EQ(sum_over_ranks(trial.computed), 600);
}

TEST(Distribute, MoreRowsThanFitAMessage) {
  PreparedRun trial(20000, 1e-7);
  trial.run();
  trial.expect_all(20000);
}

TEST(Distribute, NoRows) {
  PreparedRun trial(0);
  trial.run();
  trial.expect_all(0);
}

TEST(Distribute, FewerRowsThanRanks) {
  PreparedRun trial(1);
  trial.run();
  trial.expect_all(1);
  EXPECT_EQ(sum_over_ranks(trial.computed), 1);
}

TEST(Distribute, DedicatedManagerComputesNothingUnlessAlone) {
  PreparedRun trial(200);
  trial.job.manager_computes = false;
  trial.run();
  trial.expect_all(200);
  if (world().is_manager()) {
    EXPECT_EQ(trial.computed, world().size() == 1 ? 200 : 0);
  }
}

TEST(Distribute, LongRowsAreSpreadEvenly) {
  // All predicted to take minutes: no rank may get a second one while another has none.
  PreparedRun trial(2 * static_cast<std::uint64_t>(world().size()), 100.0);
  trial.pause = [](std::uint64_t) { return std::chrono::milliseconds(150); };
  trial.run();
  for (const auto& [rank, rows] : trial.rows_of) EXPECT_EQ(rows, 2) << "rank " << rank;
}

TEST(Distribute, RowsOfALongChunkComeInBeforeItsEnd) {
  // Predicted to be short, so all of them are one chunk; each takes 50 ms in truth.
  PreparedRun trial(20, 1e-6);
  trial.pause = [](std::uint64_t) { return std::chrono::milliseconds(50); };
  trial.run();
  trial.expect_all(20);
  // 0.2 s are four rows; twice that is left for a loaded machine
  if (world().size() == 1) {
    EXPECT_LT(trial.computed_at_first, 12);
  }
}

/// After a stop: nothing twice, and nothing lost that was computed.
void expect_stopped(const PreparedRun& trial, long at_least, long of) {
  const long computed = sum_over_ranks(trial.computed);
  EXPECT_LT(computed, of);
  if (!world().is_manager()) return;
  EXPECT_EQ(static_cast<long>(trial.came.size()), computed);
  EXPECT_GE(computed, at_least);
  for (const auto& [row, times] : trial.came) EXPECT_EQ(times, 1) << row;
  EXPECT_TRUE(trial.intact);
}

TEST(Distribute, StopLeavesOnlyTheTuplesInFlight) {
  PreparedRun trial(2000);
  trial.pause = [](std::uint64_t) { return std::chrono::milliseconds(2); };
  trial.job.stop = [&] { return world().is_manager() && trial.came.size() >= 30; };
  trial.run();
  expect_stopped(trial, 30, 2000);
}

TEST(Distribute, StopAtTheVeryBeginning) {
  PreparedRun trial(2000);
  trial.pause = [](std::uint64_t) { return std::chrono::milliseconds(2); };
  trial.job.stop = [] { return true; };
  trial.run();
  expect_stopped(trial, 0, 2000);
}

TEST(Distribute, AnyRankCanAskForTheStop) {
  PreparedRun trial(2000);
  trial.pause = [](std::uint64_t) { return std::chrono::milliseconds(2); };
  trial.job.stop = [&] { return world().rank() == world().size() - 1 && trial.computed >= 5; };
  trial.run();
  expect_stopped(trial, 5, 2000);
}

TEST(Distribute, ARankWithNothingToDoCanAskForTheStop) {
  if (world().size() == 1) return;
  PreparedRun trial(1);  // the manager gets it
  trial.job.compute = [](const SweepTask&, const auto& to_end) -> std::optional<Row> {
    while (!to_end()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
  };
  const auto begin = std::chrono::steady_clock::now();
  trial.job.stop = [&] {
    return world().rank() == world().size() - 1 && std::chrono::steady_clock::now() - begin > std::chrono::seconds(1);
  };
  trial.run();
  EXPECT_TRUE(trial.came.empty());
}

TEST(Distribute, BeginsTheShortestTaskWherePredictionsAloneSayThatNoneEndsInTime) {
  PreparedRun trial(10, 10.0);
  trial.job.max_seconds = [] { return 5.0; };
  trial.run();
  EXPECT_EQ(sum_over_ranks(trial.computed), 1);
  if (world().is_manager()) {
    EXPECT_EQ(trial.came.size(), 1u);
  }
}

TEST(Distribute, GoesOnOnAllRanksOnceItIsKnownThatTasksAreShorter) {
  PreparedRun trial(40, 10.0);
  trial.pause = [](std::uint64_t) { return std::chrono::milliseconds(20); };
  trial.job.max_seconds = [&] { return trial.came.empty() ? 5.0 : 20.0; };
  trial.run();
  trial.expect_all(40);
  if (world().is_manager()) {
    EXPECT_EQ(static_cast<int>(trial.rows_of.size()), world().size());
  }
}

TEST(Distribute, WithoutTimeBeginsNothing) {
  PreparedRun trial(10, 10.0);
  trial.job.max_seconds = [] { return 0.0; };
  trial.run();
  EXPECT_EQ(sum_over_ranks(trial.computed), 0);
}

/// The only row goes to the manager's own worker, which does not get it done before it is told to quit.
TEST(Distribute, AnOverdueTaskIsComputedOnAnIdleRank) {
  if (world().size() == 1) return;
  PreparedRun trial(1);
  trial.job.patience.overdue = 0.2;
  const auto compute = trial.job.compute;
  trial.job.compute = [&](const SweepTask& task, const auto& to_end) -> std::optional<Row> {
    if (!world().is_manager()) return compute(task, to_end);
    while (!to_end()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
  };
  trial.run();
  trial.expect_all(1);
  EXPECT_FALSE(trial.rows_of.contains(0));
}

TEST(Distribute, OfTwoAnswersTheFirstCounts) {
  if (world().size() == 1) return;
  for (const bool manager_is_first : {true, false}) {
    PreparedRun trial(1);
    trial.job.patience.overdue = 0.2;
    const bool first = world().is_manager() == manager_is_first;
    trial.pause = [first](std::uint64_t) { return std::chrono::milliseconds(first ? 600 : 1200); };
    trial.run();
    trial.expect_all(1);
    if (world().is_manager()) {
      EXPECT_EQ(trial.rows_of.contains(0), manager_is_first);
    }
  }
}

TEST(Distribute, ARankThatDoesNotAnswerAfterAStopIsNamedWithItsTask) {
  PreparedRun trial(20, 100.0);
  trial.job.patience.silent = 0.3;
  const bool is_last = world().rank() + 1 == world().size();
  trial.job.stop = [&] { return world().is_manager() && (is_last ? trial.computed > 0 : !trial.came.empty()); };
  trial.pause = [is_last](std::uint64_t) { return std::chrono::milliseconds(is_last ? 1500 : 100); };
  std::vector<SilentRank> named;
  trial.job.silent = [&](const std::vector<SilentRank>& silent) { named = silent; };
  trial.run();  // the rank answers after all
  if (!world().is_manager()) return;
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named.front().rank, world().size() - 1);
  ASSERT_TRUE(named.front().task.has_value());
  EXPECT_TRUE(trial.came.contains(*named.front().task));
}

TEST(Distribute, CanBeDoneAgainAndAgain) {
  for (int i = 0; i < 20; ++i) {
    PreparedRun trial(10);
    trial.run();
    trial.expect_all(10);
  }
}

/// Answers of any length: as many numbers as the task's index.
TEST(Distribute, AnswersMayBeVectors) {
  struct Countdown {
    std::uint64_t from = 0;
  };
  Job<Countdown, std::vector<std::uint64_t>> job;
  job.task = [](std::uint64_t index, double) { return Countdown{index}; };
  job.compute = [](const Countdown& task, const auto&) {
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t k = task.from; k > 0; --k) numbers.push_back(k);
    return std::optional(numbers);
  };
  std::set<std::vector<std::uint64_t>> came;
  job.finished = [&](std::span<const std::vector<std::uint64_t>> answers) {
    came.insert(answers.begin(), answers.end());
  };
  job.stop = [] { return false; };
  Schedule schedule({{0, 1.0}, {1, 1.0}, {2, 1.0}, {3, 1.0}}, world().size());
  distribute(world(), &schedule, job);
  if (world().is_manager()) {
    EXPECT_EQ(came, (std::set<std::vector<std::uint64_t>>{{}, {1}, {2, 1}, {3, 2, 1}}));
  }
}

TEST(Wire, RefusesMessagesThatAreTooShortForWhatTheySay) {
  wire::Bytes message;
  wire::append(message, std::vector<double>{1.0, 2.0});
  std::vector<double> values;
  for (std::size_t size = 0; size < message.size(); ++size) {
    auto cut = std::span<const std::byte>(message).first(size);
    EXPECT_THROW(wire::take(cut, values), wire::BadMessage) << size;
  }
  std::span<const std::byte> whole(message);
  wire::take(whole, values);
  EXPECT_EQ(values, (std::vector<double>{1.0, 2.0}));
  wire::Bytes huge;
  wire::append(huge, ~std::uint64_t{0});  // a count that no memory could hold
  std::span<const std::byte> rest(huge);
  EXPECT_THROW(wire::take(rest, values), wire::BadMessage);
}

TEST(World, BroadcastsTextAndNumbers) {
  const std::string text("text\0with zero, \n\xff", 18), empty;
  EXPECT_EQ(world().broadcast(world().is_manager() ? text : "other"), text);
  EXPECT_EQ(world().broadcast(world().is_manager() ? empty : "other"), empty);
  EXPECT_EQ(world().broadcast(world().is_manager() ? std::int64_t{-1} << 62 : 7), std::int64_t{-1} << 62);
}

TEST(World, ScattersContiguousBlocksInOrder) {
  for (const std::uint64_t total : {0u, 1u, 3u, 1000u}) {
    std::vector<Row> rows;
    for (std::uint64_t i = 0; world().is_manager() && i < total; ++i)
      rows.push_back({.index = i, .parameters = tuple(i), .result = {}, .timing = {}});
    const auto [first, count] = world().block(total);
    const auto mine = world().scatter(rows, total);
    ASSERT_EQ(mine.size(), count);
    for (std::uint64_t i = 0; i < count; ++i) {
      EXPECT_EQ(mine[i].index, first + i);
      EXPECT_TRUE(same_bits(mine[i].parameters.s0, tuple(first + i).s0));
    }
    EXPECT_EQ(sum_over_ranks(static_cast<long>(count)), static_cast<long>(total));
    EXPECT_LE(count, total / static_cast<std::uint64_t>(world().size()) + 1);
  }
}

}  // namespace
}  // namespace sigmasweep
