// Columns of a thousand beads: what holds for the short ones, at the ends of the parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/books.hpp"
#include "solve/exact/linear/collision.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

Parameters tuple(double epsilon, double sigma, Method method = Method::md) {
  return completed({.sigma = sigma, .epsilon = epsilon, .N = 1000, .method = method});
}

void expect_result(const SimulationResult& c) {
  ASSERT_TRUE(is_success(c.status) || c.status == Status::tolerance_missed) << int(c.status);
  EXPECT_NE(c.end, End::none);
  EXPECT_GE(c.eps_eff, 0.0);
  EXPECT_LE(c.eps_eff, 1.0 + c.eps_eff_error);
  EXPECT_NEAR(c.eps_eff * c.eps_eff, c.Er_E0 + c.v_cm * c.v_cm, 1e-12);
}

TEST(ThousandBeads, WithoutDashpotsNothingIsLost) {
  const SimulationResult touching = simulate(tuple(1.0, 0.0));
  ASSERT_EQ(touching.status, Status::ok);
  EXPECT_NEAR(touching.eps_eff, 1.0, std::min(1e-10, touching.eps_eff_error));
}

TEST(ThousandBeads, GiveAResultAtEveryRestitution) {
  for (const double epsilon : {1.0 - 1e-12, 0.5, 1e-6})
    for (const double sigma : {0.0, 1e-16}) {
      SCOPED_TRACE(testing::Message() << "eps " << epsilon << " sigma " << sigma);
      const SimulationResult c = simulate(tuple(epsilon, sigma));
      expect_result(c);
      EXPECT_EQ(c.status, Status::ok);
    }
}

// Twenty contact times: the wave is on its way up, and all of the column is in the books.
TEST(ThousandBeads, KeepTheirBooks) {
  for (const double epsilon : {1.0, 0.5, 1e-3}) {
    const auto column = reduced_column<double>(tuple(epsilon, 1e-3));
    const auto books = books::of(column, 20.0, 400, observe_exact);
    SCOPED_TRACE(epsilon);
    EXPECT_LE(books.energy_imbalance(), 1e-12 * 1000.0);
    EXPECT_LE(books.momentum_imbalance(), 1e-12 * 1000.0);
    EXPECT_LE(books.largest_rise_of_energy(), 1e-12 * 1000.0);
  }
}

TEST(ThousandBeads, OnlySigmaCounts) {
  const SimulationResult expected = simulate(tuple(0.9, 1e-9));
  Parameters p = tuple(0.9, 1e-9);
  p.v0 *= 0x1p-30;
  p.tc *= 0x1p20;
  const SimulationResult c = simulate(complete(p, GapParameter::sigma));
  EXPECT_EQ(c.eps_eff, expected.eps_eff);
  EXPECT_EQ(c.contacts, expected.contacts);
  EXPECT_EQ(c.t_k, expected.t_k * 0x1p20);
}

TEST(ThousandBeads, HardOnesGiveAResult) {
  for (const double epsilon : {1.0, 1.0 - 1e-12, 0.999, 0.5, 1e-6}) {
    SCOPED_TRACE(epsilon);
    const SimulationResult c = simulate(tuple(epsilon, 1.0, Method::ed));
    expect_result(c);
    if (epsilon == 1.0) {
      EXPECT_EQ(c.contacts, 500'500u);  // N (N + 1)/2
      EXPECT_NEAR(c.eps_eff, 1.0, c.eps_eff_error);
    }
    if (epsilon == 0.5) {
      EXPECT_EQ(c.status, Status::collapsed);
    }
  }
}

}  // namespace
