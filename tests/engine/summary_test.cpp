#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/duration.hpp"
#include "engine/report/summary.hpp"

namespace sigmasweep {
namespace {

Row row(double sigma, double v0, double eps_eff, Status status = Status::ok) {
  Row row;
  row.parameters.sigma = sigma;
  row.parameters.v0 = v0;
  row.parameters.tc = 1e-5;
  row.parameters.s0 = sigma * v0 * 1e-5;
  row.result.eps_eff = eps_eff;
  row.result.eps_eff_error = 1e-14;
  row.result.status = status;
  row.timing.run_time = 1e-3;
  return row;
}

TEST(Universality, GroupsEqualSigmaAndFindsTheWorst) {
  const std::vector<Row> rows{row(1, 0.2, 0.5),         row(0.1, 0.2, 0.9),       row(1, 14, 0.5 + 3e-3),
                              row(0.1, 14, 0.9 + 1e-3), row(1, 0.05, 0.5 - 1e-3), row(10, 1, 0.3)};
  const Universality found = universality(rows);
  EXPECT_EQ(found.groups, 2u);
  EXPECT_NEAR(found.spread, 4e-3, 1e-15);  // three roundings of numbers near 1/2
  EXPECT_EQ(found.sigma, 1.0);
}

TEST(Universality, SigmaMayDifferByRoundingOnly) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(universality(std::vector{row(1, 1, 0.5), row(next, 2, 0.5)}).groups, 1u);
  EXPECT_EQ(universality(std::vector{row(1, 1, 0.5), row(1 + 1e-11, 2, 0.5)}).groups, 0u);
  EXPECT_EQ(universality(std::vector{row(0, 1, 0.5), row(0, 2, 0.5)}).groups, 1u);
  EXPECT_EQ(universality(std::vector{row(0, 1, 0.5), row(1e-300, 2, 0.5)}).groups, 0u);
}

TEST(Universality, FineAxesDoNotCreepIntoOneGroup) {
  std::vector<Row> rows;
  for (int i = 0; i < 100; ++i) rows.push_back(row(1.0 + 0.6e-12 * i, 1.0 + i, 0.5 + 1e-3 * i));
  EXPECT_NEAR(universality(rows).spread, 1e-3, 1e-15);  // two by two
}

TEST(Universality, OtherPhysicsIsAnotherPoint) {
  for (const auto change : std::vector<void (*)(Parameters&)>{
           [](Parameters& p) { p.N = 11; }, [](Parameters& p) { p.epsilon = 0.8; },
           [](Parameters& p) { p.method = Method::ed; }, [](Parameters& p) { p.wall = Wall::matched; },
           [](Parameters& p) { p.integrator = Integrator::gear5; }, [](Parameters& p) { p.tolerance = 1e-8; }}) {
    std::vector<Row> rows{row(1, 1, 0.5), row(1, 2, 0.6)};
    ASSERT_EQ(universality(rows).groups, 1u);
    change(rows[1].parameters);
    EXPECT_EQ(universality(rows).groups, 0u);
  }
}

/// Whose beads' size counts, in the unit of length v0 tc.
TEST(Universality, OfLatticesNeedsBeadsOfTheSameSize) {
  std::vector<Row> rows{row(1, 1, 0.5), row(1, 2, 0.6)};
  for (Row& r : rows) r.parameters.geometry = Geometry::lattice;
  EXPECT_EQ(universality(rows).groups, 0u);
  rows[1].parameters.d *= 2.0;
  EXPECT_EQ(universality(rows).groups, 1u);
  for (const auto change : std::vector<void (*)(Parameters&)>{
           [](Parameters& p) { p.rows += 1; }, [](Parameters& p) { p.columns += 1; },
           [](Parameters& p) { p.side_walls = SideWalls::fixed; }, [](Parameters& p) { p.D_t = 1.0; },
           [](Parameters& p) { p.geometry = Geometry::column; }}) {
    std::vector<Row> others = rows;
    change(others[1].parameters);
    EXPECT_EQ(universality(others).groups, 0u);
  }
}

TEST(Universality, IgnoresRepeatedRowsAndRowsWithoutAResult) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(universality(std::vector{row(1, 1, 0.5), row(1, 1, 0.5)}).groups, 0u);
  EXPECT_EQ(universality(std::vector{row(1, 1, 0.5), row(1, 2, nan, Status::failed)}).groups, 0u);
  EXPECT_EQ(universality(std::vector{row(1, 1, 0.5), row(1, 2, 0.9, Status::unstable)}).groups, 0u);
  EXPECT_EQ(universality(std::vector<Row>{}).groups, 0u);
}

bool has_line(const std::string& text, const std::string& words) {
  std::string squeezed;  // runs of spaces as one
  for (const char c : text)
    if (c != ' ' || (!squeezed.empty() && squeezed.back() != ' ')) squeezed += c;
  return ("\n" + squeezed).find(words + "\n") != std::string::npos;
}

TEST(Summary, CountsQuantilesAndMakespan) {
  std::vector<Row> rows;
  for (int i = 1; i <= 100; ++i) {
    rows.push_back(row(i, 1, 0.5));
    rows.back().timing.run_time = i;
    rows.back().result.eps_eff_error = i * 1e-12;
  }
  rows[6].result.status = Status::collapsed;
  rows[7].result.status = Status::failed;
  rows[7].result.eps_eff_error = std::numeric_limits<double>::quiet_NaN();
  // sum 5050 s: on 4 ranks 1262.5 s at best, of which 2525 s is twice as much
  const std::string text = summary(rows, 4, 2525.0);
  EXPECT_TRUE(has_line(text, "100 rows")) << text;
  EXPECT_TRUE(has_line(text, " ok 98")) << text;
  EXPECT_TRUE(has_line(text, " collapsed 1")) << text;
  EXPECT_TRUE(has_line(text, " failed 1")) << text;
  EXPECT_TRUE(has_line(text, " eps_eff_error 5.1e-11 9.1e-11 1.0e-10 1.0e-10")) << text;
  EXPECT_TRUE(has_line(text, " run_time 50 s 1 min 30 s 1 min 39 s 1 min 40 s")) << text;
  EXPECT_NE(text.find("50.0 % of the best possible"), std::string::npos) << text;
}

TEST(Summary, OneLongRowBoundsTheMakespan) {
  std::vector<Row> rows{row(1, 1, 0.5), row(2, 1, 0.5)};
  rows[0].timing.run_time = 9.0;
  EXPECT_NE(summary(rows, 8, 18.0).find("50.0 % of the best possible"), std::string::npos) << summary(rows, 8, 18.0);
}

TEST(Summary, NothingComputedNothingClaimed) {
  EXPECT_EQ(summary(std::vector<Row>{}, 1, 0.0).find("best possible"), std::string::npos);
  EXPECT_EQ(summary(std::vector{row(1, 1, 0.5)}, 1, 0.0).find("best possible"), std::string::npos);
  EXPECT_EQ(summary(std::vector{row(1, 1, 0.5)}, Work{}, 1, 5.0).find("best possible"), std::string::npos);
}

TEST(ReadableDuration, FromMicrosecondsToDays) {
  EXPECT_EQ(readable_duration(1.234e-5), "12.3 us");
  EXPECT_EQ(readable_duration(0.0123), "12.3 ms");
  EXPECT_EQ(readable_duration(1.26), "1.3 s");
  EXPECT_EQ(readable_duration(59.4), "59 s");
  EXPECT_EQ(readable_duration(59.9), "1 min 00 s");
  EXPECT_EQ(readable_duration(3599.7), "1 h 00 min");
  EXPECT_EQ(readable_duration(5 * 3600.0 + 12 * 60), "5 h 12 min");
  EXPECT_EQ(readable_duration(3 * 86400.0 + 7300), "3 d 2 h");
  EXPECT_EQ(readable_duration(std::numeric_limits<double>::infinity()), "?");
}

TEST(Summary, TellsABusyMachineFromABadSchedule) {
  const std::vector rows{row(1, 1, 0.5)};
  // 2 ranks, 100 s: one has nothing to do half of the time, both share their processor with one other process.
  const Work work{.rows = 1, .cpu_seconds = 75.0, .longest_seconds = 1.0, .computing_seconds = 150.0};
  const std::string text = summary(rows, work, 2, 100.0);
  EXPECT_NE(text.find("ranks had a row 75 % of the time, and then 50 % of a processor each"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace sigmasweep
