// Properties of simulate() over the whole box of parameters, by RapidCheck. A failing case is shrunk and printed with
// what repeats it; RC_PARAMS="seed=... max_success=..." runs others. A case that fails gets
// a test of its own, with its name.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>
#include <string>

#include "sigmasweep/scene/names.hpp"
#include "sigmasweep/scene/real.hpp"
#include "sigmasweep/solve/exact.hpp"
#include "sigmasweep/solve/simulate.hpp"

namespace {

using namespace sigmasweep;

std::string shown(const Parameters& p) {
  std::ostringstream s;
  s << std::hexfloat << "method " << name_of(p.method) << " law " << name_of(p.law) << " integrator "
    << name_of(p.integrator) << " wall " << name_of(p.wall) << " ed_rule " << name_of(p.ed_rule) << " N " << p.N
    << " v0 " << p.v0 << " tc " << p.tc << " s0 " << p.s0 << " sigma " << p.sigma << " epsilon " << p.epsilon
    << " K_over_m " << p.K_over_m << " D_n " << p.D_n << " beta " << p.beta << " gamma " << p.gamma << " d " << p.d
    << " width " << p.width << " steps_per_tc " << p.steps_per_tc << " tolerance " << p.tolerance << " seed " << p.seed
    << " random_separation " << name_of(p.random_separation);
  return s.str();
}

/// From 10^from to 10^to, a hundredth of a decade apart: shrinks to 10^from.
rc::Gen<double> decades(int from, int to) {
  return rc::gen::map(rc::gen::inRange(0, 100 * (to - from) + 1),
                      [from](int i) { return std::pow(10.0, from + 0.01 * i); });
}
rc::Gen<double> epsilons() {
  return rc::gen::oneOf(rc::gen::element(1.0, 1.0 - 1e-12, 0.99, 0.9, 0.5, 0.1, 1e-3, 1e-6),
                        rc::gen::map(rc::gen::inRange(1, 1001), [](int i) { return 1e-3 * i; }));
}
rc::Gen<double> gaps() { return rc::gen::oneOf(rc::gen::element(0.0, 1e-300, 1e-16), decades(-12, 12)); }

template <class Enum>
rc::Gen<Enum> any_of() {
  return rc::gen::map(rc::gen::inRange<std::size_t>(0, names_of<Enum>().size()),
                      [](std::size_t i) { return static_cast<Enum>(i); });
}

struct Box {
  int most_beads = 30;
  bool soft_only = false, linear_only = false, exact_only = false;
};

Parameters drawn(const Box& box) {
  Parameters p;
  p.method = box.soft_only ? Method::md : *any_of<Method>();
  const auto laws = rc::gen::weightedOneOf<Law>({{2, rc::gen::just(Law::hooke)}, {1, any_of<Law>()}});
  p.law = box.linear_only ? Law::hooke : *laws;
  if (p.law == Law::power) {
    p.beta = 0.125 * *rc::gen::inRange(0, 13);
    p.gamma = 0.125 * *rc::gen::inRange(0, 9);
  }
  if (!box.exact_only && p.method == Method::md && *rc::gen::inRange(0, 8) == 7) {
    p.integrator = *any_of<Integrator>();
    p.steps_per_tc = *rc::gen::inRange(2, 200);
  }
  p.N = p.law == Law::hooke ? *rc::gen::inRange(1, box.most_beads + 1) : *rc::gen::inRange(1, 9);
  p.wall = *any_of<Wall>();
  p.ed_rule = p.method == Method::ed ? *any_of<EdRule>() : EdRule::lrv;
  p.v0 = *decades(-15, 3);
  p.tolerance = *decades(-12, -2);
  p.seed = *rc::gen::inRange(0, 1000);
  p.random_separation = *any_of<Flag>();
  if (*rc::gen::inRange(0, 3) == 2) p.width = p.d * 0.01 * *rc::gen::inRange(0, 200);
  if (p.law == Law::hooke && *rc::gen::inRange(0, 3) == 2) {  // damping ratios from weak to well overdamped
    p.K_over_m = *decades(2, 14);
    const double ratio = *rc::gen::oneOf(rc::gen::element(0.0, 1.0 - 1e-12, 1.0, 1.0 + 1e-12), decades(-4, 2));
    p.D_n = ratio * std::sqrt(p.K_over_m);
    if (ratio >= 1.0 - 1e-3) p.method = Method::md;
  } else {
    p.tc = *decades(-9, 1);
    p.epsilon = *epsilons();
  }
  p.sigma = *gaps();
  return complete(p, Gap::sigma);
}

void check_consistent(const Parameters& p, const Collision& c) {
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
  RC_ASSERT(c.end != End::none);
  if (p.integrator == Integrator::exact) RC_ASSERT((c.status == Status::tolerance_missed) == (bar > p.tolerance));
}

void check_collision(const Parameters& p) {
  RC_LOG() << shown(p);
  RC_PRE(why_invalid(p).empty());
  const std::clock_t start = std::clock();
  const Collision c = simulate(p);
  const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RC_TAG(std::string(name_of(c.status)));
  check_consistent(p, c);
  RC_ASSERT(taken < 30.0);  // s of computing; some overdamped nonlinear columns take ten
}

TEST(AnyParameters, GiveAConsistentResultOrAStatus) {
  EXPECT_TRUE(rc::check("simulate() returns, and its numbers fit together", [] { check_collision(drawn({})); }));
}

/// eps_eff of the linear law in long double or, where that is not enough, 113 bits.
double true_error(const Parameters& p, double eps_eff, double bar) {
  const auto in = [&](auto real) {
    using Real = decltype(real);
    using std::abs;
    const auto column = reduced_column<Real>(p);
    ExactOptions options;
    options.settle = 1e-17;
    options.work_limit = std::numeric_limits<Real>::digits > 64 ? 100'000 : 2'000'000;  // about a second
    const auto outcome = exact_collision(column, options);
    if (outcome.status != Status::ok) return 0.0;  // cannot tell
    return double(abs(energies<Real>(outcome.velocity, Real(1), column.mass).eps_eff - Real(eps_eff)));
  };
  const double error = in(0.0L);
  return error <= bar ? error : in(Quad(0));
}

// The error bar is one for 99.9 % of tuples; ten times it must hold for all. 2e-16: eps_eff is rounded to double.
TEST(AnyParameters, TheTruthIsWithinTheErrorBar) {
  EXPECT_TRUE(rc::check("eps_eff is as good as it says", [] {
    const Parameters p = drawn({.most_beads = 12, .soft_only = true, .linear_only = true, .exact_only = true});
    RC_LOG() << shown(p);
    RC_PRE(why_invalid(p).empty());
    const Collision c = simulate(p);
    RC_PRE(c.status == Status::ok);
    const double error = true_error(p, c.eps_eff, c.eps_eff_error);
    RC_LOG() << " error " << error << " bar " << c.eps_eff_error;
    RC_ASSERT(error <= 10.0 * c.eps_eff_error + 2e-16);
  }));
}

// Powers of two in v0 and tc leave every digit of sigma, and so of the result.
TEST(AnyParameters, OnlySigmaCounts) {
  EXPECT_TRUE(rc::check("the same at any speed", [] {
    Parameters p = drawn({.most_beads = 8, .exact_only = true});
    RC_LOG() << shown(p);
    RC_PRE(why_invalid(p).empty() && p.K_over_m == 0.0);
    const Collision a = simulate(p);
    p.v0 *= 0x1p-7;
    p.tc *= 0x1p11;
    const Collision b = simulate(complete(p, Gap::sigma));
    RC_ASSERT(a.status == b.status && a.contacts == b.contacts);
    RC_ASSERT(std::isnan(a.eps_eff) || (a.eps_eff == b.eps_eff && a.eps_eff_error == b.eps_eff_error));
    RC_ASSERT(std::isnan(a.t_k) || std::fabs(a.t_k * 0x1p11 - b.t_k) <= 1e-15 * b.t_k);
  }));
}

}  // namespace
