#include "engine/report/measured_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sigmasweep/solve/cost.hpp"

namespace sigmasweep {
namespace {

/// Hard spheres are computed one by one, whatever is predicted.
constexpr const char* spec = R"(
[sweep]
method = "ed"
v0 = 0.1
tc = 1e-5
epsilon = { from = 0.7, to = 0.9, count = 40 }
N = [2, 5, 10]
sigma = [0.5, 2.0]
)";

std::vector<ScheduledTask> tasks_of(const Sweep& sweep, double factor) {
  std::vector<ScheduledTask> tasks;
  for (std::uint64_t row = 0; row < sweep.size(); ++row) tasks.push_back({row, factor * predicted_time(sweep.at(row))});
  return tasks;
}

TEST(MeasuredCost, SeesPredictionsThatAreWrongAThousandfold) {
  const Sweep sweep = Sweep::parse(spec, "spec");
  const MeasuredCost low = measure_cost(sweep, tasks_of(sweep, 1e-3), 30);
  const MeasuredCost high = measure_cost(sweep, tasks_of(sweep, 1e3), 30);
  ASSERT_EQ(low.ratios.size(), 30u);
  EXPECT_TRUE(std::ranges::is_sorted(low.ratios));
  // A million, with ten for a machine that is busy meanwhile.
  EXPECT_GT(low.mean / high.mean, 1e5);
  EXPECT_LT(low.mean / high.mean, 1e7);
  EXPECT_GT(high.mean, 0.0);
  EXPECT_LE(low.quantile(0.1), low.quantile(0.9));
  EXPECT_EQ(low.quantile(0.0), low.ratios.front());
  EXPECT_EQ(low.quantile(1.0), low.ratios.back());
  EXPECT_EQ(low.given_up, 0u);
}

TEST(MeasuredCost, MeasuresAtMostAsManyRowsAsThereAre) {
  const Sweep sweep = Sweep::parse("[sweep]\nv0 = 0.1\ntc = 1e-5\nepsilon = 0.9\nN = 3\nsigma = [0.5, 2.0]\n", "spec");
  EXPECT_EQ(measure_cost(sweep, tasks_of(sweep, 1.0), 50).ratios.size(), 2u);
}

TEST(MeasuredCost, GivesUpRowsThatTakeTooLong) {
  const Sweep sweep = Sweep::parse(
      "[sweep]\nv0 = 0.1\ntc = 1e-5\nepsilon = 0.9\nN = 200\nsigma = 0.3\nintegrator = \"verlet\"\nsteps_per_tc = "
      "500\n",
      "spec");
  EXPECT_EQ(measure_cost(sweep, tasks_of(sweep, 1.0), 1, 1e-3).given_up, 1u);
}

}  // namespace
}  // namespace sigmasweep
