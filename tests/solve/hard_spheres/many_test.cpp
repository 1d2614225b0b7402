#include "solve/hard_spheres/many.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"

/// Hard spheres that differ in their units only are computed once: to the bit what each of them is alone.
namespace sigmasweep {
namespace {

std::vector<Parameters> columns() {
  std::vector<Parameters> all;
  for (const std::int64_t N : {1, 2, 5, 10, 25})
    for (const double epsilon : {0.05, 0.3, 0.83, 0.9, 1.0})
      for (const Wall wall : {Wall::paper, Wall::matched})
        for (const double sigma : {0.0, 1e-3, 0.7, 31.0})
          for (const double v0 : {0.2, 1.7})
            all.push_back(
                hard_column({.v0 = v0, .tc = 1e-5 / v0, .sigma = sigma, .epsilon = epsilon, .N = N, .wall = wall}));
  Parameters other = hard_column({.sigma = 1.0, .epsilon = 0.9, .N = 6});
  other.width = 0.2 * other.d;
  all.push_back(other);
  other.width = 0.0;
  other.random_separation = Flag::yes;
  all.push_back(other);
  other.random_separation = Flag::no;
  other.ed_rule = EdRule::tc;
  all.push_back(other);
  other.ed_rule = EdRule::lrv;
  other.tolerance = 1e-3;
  all.push_back(other);
  return all;
}

void expect_same(double a, double b) { EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)); }

TEST(ManyHardSpheres, AreWhatEachIsAlone) {
  std::vector<Parameters> all = columns();
  std::ranges::shuffle(all, std::mt19937(7));
  std::vector<SimulationResult> together(all.size());
  for (SimulationResult& c : together) c.status = Status::not_run;
  simulate_hard_spheres_many(all, together);
  std::size_t shared = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SimulationResult &c = together[i], alone = simulate(all[i]);
    if (c.status == Status::not_run) continue;
    ++shared;
    EXPECT_EQ(c.status, alone.status) << i;
    EXPECT_EQ(c.end, alone.end) << i;
    EXPECT_EQ(c.contacts, alone.contacts) << i;
    expect_same(c.eps_eff, alone.eps_eff);
    expect_same(c.eps_eff_error, alone.eps_eff_error);
    expect_same(c.Er_Ef, alone.Er_Ef);
    expect_same(c.Er_Ef_error, alone.Er_Ef_error);
    expect_same(c.v_cm, alone.v_cm);
    expect_same(c.v_cm_error, alone.v_cm_error);
    expect_same(c.t_k, alone.t_k);
  }
  EXPECT_GT(shared, 8 * all.size() / 10);
}

/// Other masses, gaps and rules have other results.
TEST(ManyHardSpheres, LeaveWhatTheyDoNotShare) {
  const std::vector<Parameters> all = columns();
  std::vector<SimulationResult> together(all.size());
  for (SimulationResult& c : together) c.status = Status::not_run;
  simulate_hard_spheres_many(all, together);
  for (std::size_t i = all.size() - 4; i + 1 < all.size(); ++i) EXPECT_EQ(together[i].status, Status::not_run);
}

}  // namespace
}  // namespace sigmasweep
