// Properties of simulate() over the whole box of parameters.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/any_parameters.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;
using namespace sigmasweep::any_parameters;

void check_consistent(const Parameters& p, const SimulationResult& c) {
  if (!is_success(c.status) && c.status != Status::tolerance_missed) {
    RC_ASSERT(std::isnan(c.eps_eff) && std::isnan(c.eps_eff_error) && std::isnan(c.v_cm));
    return;
  }
  const double bar = c.eps_eff_error;
  const double rounding = 1e-14 * static_cast<double>(p.N);  // of sums over the beads
  RC_ASSERT(std::isfinite(bar) && bar >= 0.0);
  RC_ASSERT(c.eps_eff >= 0.0 && c.eps_eff <= 1.0 + bar);
  RC_ASSERT(c.Er_Ef >= 0.0 && c.Er_Ef <= 1.0);
  RC_ASSERT(std::fabs(c.eps_eff * c.eps_eff - c.Er_E0 - c.v_cm * c.v_cm) <= rounding);
  RC_ASSERT(c.t_k >= 0.0 && c.x_max >= 0.0);
  // Only hard spheres that collide too often give up with a result, and an error bar that says so.
  const bool gave_up = p.method == Method::ed && c.status == Status::tolerance_missed && c.contacts >= 150'000;
  RC_ASSERT(c.end != End::none || gave_up);
  if (p.integrator == Integrator::exact) RC_ASSERT((c.status == Status::tolerance_missed) == (bar > p.tolerance));
}

void check_collision(const Parameters& p) {
  RC_LOG() << shown(p);
  RC_PRE(why_invalid(p).empty());
  const std::clock_t start = std::clock();
  const SimulationResult c = simulate(p);
  const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RC_TAG(std::string(name_of(c.status)));
  check_consistent(p, c);
  RC_ASSERT(taken < 30.0);  // s of computing; some overdamped nonlinear columns take ten
}

TEST(AnyParameters, GiveAConsistentResultOrAStatus) {
  EXPECT_TRUE(
      rc::check("simulate() returns, and its numbers fit together", [] { check_collision(drawn(Solver::any)); }));
}

// Powers of two in v0 and tc leave every digit of sigma, and so of the result.
TEST(AnyParameters, OnlySigmaCounts) {
  EXPECT_TRUE(rc::check("the same at any speed", [] {
    Parameters p = drawn(Solver::any, 8);
    RC_LOG() << shown(p);
    RC_PRE(why_invalid(p).empty() && p.K_over_m == 0.0);
    const SimulationResult a = simulate(p);
    p.v0 *= 0x1p-7;
    p.tc *= 0x1p11;
    const SimulationResult b = simulate(completed(p));
    RC_ASSERT(a.status == b.status && a.contacts == b.contacts);
    RC_ASSERT(std::isnan(a.eps_eff) || (a.eps_eff == b.eps_eff && a.eps_eff_error == b.eps_eff_error));
    RC_ASSERT(std::isnan(a.t_k) || std::fabs(a.t_k * 0x1p11 - b.t_k) <= 1e-15 * b.t_k);
  }));
}

// Nothing is lost without dashpots, whatever the masses and gaps.
TEST(AnyParameters, ElasticColumnsKeepTheirEnergy) {
  EXPECT_TRUE(rc::check("eps_eff = 1", [] {
    Parameters p = drawn(*rc::gen::element(Solver::linear, Solver::nonlinear, Solver::hard));
    p.epsilon = 1.0;
    p.K_over_m = p.D_n = 0.0;
    p = completed(p);
    RC_LOG() << shown(p);
    RC_PRE(why_invalid(p).empty());
    const SimulationResult c = simulate(p);
    RC_ASSERT(c.status == Status::ok || c.status == Status::tolerance_missed);
    RC_LOG() << " eps_eff - 1 " << c.eps_eff - 1.0 << " bar " << c.eps_eff_error;
    RC_ASSERT(std::fabs(c.eps_eff - 1.0) <= c.eps_eff_error);
  }));
}

// One bead has the wall's restitution, soft or hard, whatever the gap: exp(-pi L/sqrt(2 pi^2 + L^2)), L = -ln epsilon,
// or a pair's. 4e-16: two roundings.
TEST(AnyParameters, OneBeadComesBackWithTheWallsRestitution) {
  EXPECT_TRUE(rc::check("N = 1", [] {
    Parameters p = drawn(*rc::gen::element(Solver::linear, Solver::hard), 1);
    p.width = 0.0;  // the mean bead
    RC_LOG() << shown(p);
    RC_PRE(why_invalid(p).empty() && p.K_over_m == 0.0);
    const double L = -std::log(p.epsilon), pi = std::numbers::pi;
    const double wall = p.wall == Wall::matched ? p.epsilon : std::exp(-pi * L / std::sqrt(2.0 * pi * pi + L * L));
    const SimulationResult c = simulate(p);
    RC_LOG() << " eps_eff " << c.eps_eff << " expected " << wall;
    RC_ASSERT(c.contacts == 1u);
    RC_ASSERT(c.status == Status::ok);
    RC_ASSERT(std::fabs(c.eps_eff - wall) <= 4e-16 * std::max(1.0, L));
  }));
}

}  // namespace
