#include "engine/stop/deadline.hpp"

#include <gtest/gtest.h>

#include "base/duration.hpp"

namespace sigmasweep {
namespace {

Timing timing(double run_time, double predicted_time) {
  Timing timing;
  timing.run_time = run_time;
  timing.predicted_time = predicted_time;
  return timing;
}

Deadline in_a_hundred_seconds(double crowding = 1.0) {
  return {Deadline::Clock::now() + std::chrono::seconds(100), crowding};
}

TEST(Deadline, TrustsNoPredictionBeforeRowsAreDone) {
  const Deadline deadline = in_a_hundred_seconds(), crowded = in_a_hundred_seconds(2.0);
  EXPECT_NEAR(deadline.max_seconds(), 100.0 / 3.0, 1.0);
  EXPECT_NEAR(crowded.max_seconds(), 50.0 / 3.0, 1.0);
}

TEST(Deadline, LearnsFromOneRow) {
  Deadline deadline = in_a_hundred_seconds();
  deadline.learn(timing(12.0, 10.0));
  EXPECT_GE(deadline.factor(), 1.2);
  EXPECT_LE(deadline.factor(), 1.2 * 1.05 + 1e-12);  // the width of a step
}

TEST(Deadline, TakesTheQuantile) {
  Deadline deadline = in_a_hundred_seconds();
  for (int k = 0; k < 1000; ++k) deadline.learn(timing(k % 100 < 4 ? 50.0 : k % 100 < 10 ? 2.0 : 1.0, 1.0));
  EXPECT_GE(deadline.factor(), 2.0);
  EXPECT_LE(deadline.factor(), 2.0 * 1.05 + 1e-12);
}

TEST(Deadline, ShortRowsSayLittle) {
  Deadline deadline = in_a_hundred_seconds();
  deadline.learn(timing(10.0, 10.0));
  for (int k = 0; k < 1000; ++k) deadline.learn(timing(1e-4, 1e-6));  // a thousand of them are 1 ms
  EXPECT_LE(deadline.factor(), 1.05 + 1e-12);
}

TEST(Deadline, IgnoresWhatWasNotTimed) {
  Deadline deadline = in_a_hundred_seconds();
  deadline.learn(timing(0.0, 1.0));
  deadline.learn(timing(1.0, 0.0));
  deadline.learn(Timing{});
  EXPECT_EQ(deadline.factor(), 3.0);
}

TEST(Deadline, IsOverWhenTheTimeIsUp) {
  const Deadline over(Deadline::Clock::now() - std::chrono::seconds(1), 1.0);
  EXPECT_LT(over.max_seconds(), 0.0);
}

TEST(Deadline, KeepsTimeForTheEnd) {
  EXPECT_EQ(time_for_the_end(3600.0, 1e6), 10.0);
  EXPECT_EQ(time_for_the_end(5.0, 1e3), 0.5);
  EXPECT_EQ(time_for_the_end(3600.0, 20e9), 1000.0);
}

TEST(Duration, SecondsOrAsSlurmWritesThem) {
  EXPECT_EQ(parse_duration("0"), 0.0);
  EXPECT_EQ(parse_duration("90"), 90.0);
  EXPECT_EQ(parse_duration("0.5"), 0.5);
  EXPECT_EQ(parse_duration("1:30"), 90.0);
  EXPECT_EQ(parse_duration("2:00:01"), 7201.0);
  EXPECT_EQ(parse_duration("1-0"), 86400.0);
  EXPECT_EQ(parse_duration("1-2:03"), 93780.0);
  EXPECT_EQ(parse_duration("1-02:03:04"), 93784.0);
}

TEST(Duration, NothingElse) {
  for (const char* text : {"", "x", "1x", "-1", "inf", "nan", "1e999", "1:", ":1", "1::2", "1:2:3:4", "1-", "-",
                           "1-2-3", "1:-2", "1.5:00", " 1", "1 ", "UNLIMITED"})
    EXPECT_FALSE(parse_duration(text)) << '"' << text << '"';
}

}  // namespace
}  // namespace sigmasweep
