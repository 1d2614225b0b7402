// Over the whole box of parameters: is eps_eff as good as eps_eff_error says? Each solver against wider arithmetic. The
// error bar is one for 99.9 % of tuples; ten times it must hold for all. 2e-16: eps_eff is rounded to double.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "any_parameters.hpp"
#include "plain_hard_spheres.hpp"
#include "sigmasweep/scene/real.hpp"
#include "sigmasweep/solve/exact.hpp"
#include "sigmasweep/solve/nonlinear.hpp"
#include "sigmasweep/solve/simulate.hpp"

namespace {

using namespace sigmasweep;
using namespace sigmasweep::any_parameters;

constexpr double cannot_tell = 0.0;

/// Of the linear law in long double or, where that is not enough, 113 bits.
double linear_error(const Parameters& p, const Collision& c) {
  const auto in = [&](auto real) {
    using Real = decltype(real);
    using std::abs;
    const auto column = reduced_column<Real>(p);
    ExactOptions options;
    options.settle = 1e-17;
    options.work_limit = std::numeric_limits<Real>::digits > 64 ? 100'000 : 2'000'000;  // about a second
    const auto outcome = exact_collision(column, options);
    if (outcome.status != Status::ok) return cannot_tell;
    return double(abs(energies<Real>(outcome.velocity, Real(1), column.mass).eps_eff - Real(c.eps_eff)));
  };
  const double error = in(0.0L);
  return error <= c.eps_eff_error ? error : in(Quad(0));
}

/// Of the other laws, with local errors of 1e-16.
double nonlinear_error(const Parameters& p, const Collision& c) {
  const auto column = reduced_column<long double>(p);
  NonlinearOptions options;
  options.accuracy = 1e-16;
  options.settle = 1e-15;
  options.work_limit = 1'000'000;
  const auto outcome = nonlinear_collision(column, options);
  if (outcome.status != Status::ok) return cannot_tell;
  return std::fabs(double(energies<long double>(outcome.velocity, 1.0L, column.mass).eps_eff - c.eps_eff));
}

double hard_error(const Parameters& p, const Collision& c) {
  using plain_hard_spheres::Wide;
  const auto column = reduced_column<Quad>(p);
  plain_hard_spheres::Plain plain(column, p.ed_rule);
  if (!plain.run(5'000)) return cannot_tell;  // a long collapse
  return std::fabs(static_cast<double>(Wide(c.eps_eff) - plain.eps_eff(Wide(column.speed))));
}

double true_error(const Parameters& p, const Collision& c) {
  if (p.method == Method::ed) return hard_error(p, c);
  return p.law == Law::hooke ? linear_error(p, c) : nonlinear_error(p, c);
}

void check_truth(Solver solver, int most_beads) {
  const Parameters p = drawn(solver, most_beads);
  RC_LOG() << shown(p);
  RC_PRE(why_invalid(p).empty());
  const Collision c = simulate(p);
  RC_TAG(std::string(name_of(c.status)));
  RC_PRE(is_success(c.status) || c.status == Status::tolerance_missed);
  const double error = true_error(p, c);
  RC_LOG() << " error " << error << " bar " << c.eps_eff_error;
  RC_ASSERT(error <= 10.0 * c.eps_eff_error + 2e-16);
}

TEST(AnyErrorBar, OfTheLinearLaw) {
  EXPECT_TRUE(rc::check("exact, linear", [] { check_truth(Solver::linear, 12); }));
}

TEST(AnyErrorBar, OfTheOtherLaws) {
  EXPECT_TRUE(rc::check("exact, not linear", [] { check_truth(Solver::nonlinear, 8); }));
}

TEST(AnyErrorBar, OfHardSpheres) {
  EXPECT_TRUE(rc::check("hard spheres", [] { check_truth(Solver::hard, 12); }));
}

TEST(AnyErrorBar, OfFixedSteps) {
  EXPECT_TRUE(rc::check("fixed steps", [] { check_truth(Solver::fixed_step, 8); }));
}

}  // namespace
