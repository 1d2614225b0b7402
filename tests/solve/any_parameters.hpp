#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "support/parameters.hpp"

/// Random tuples from the whole box of parameters, for RapidCheck. A failing case is shrunk and printed with what
/// repeats it; RC_PARAMS="seed=... max_success=..." runs others. A case that fails gets a test with its name.
namespace sigmasweep::any_parameters {

inline std::string shown(const Parameters& p) {
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
inline rc::Gen<double> decades(int from, int to) {
  return rc::gen::map(rc::gen::inRange(0, 100 * (to - from) + 1),
                      [from](int i) { return std::pow(10.0, from + 0.01 * i); });
}
inline rc::Gen<double> epsilons() {
  return rc::gen::oneOf(rc::gen::element(1.0, 1.0 - 1e-12, 0.99, 0.9, 0.5, 0.1, 1e-3, 1e-6),
                        rc::gen::map(rc::gen::inRange(1, 1001), [](int i) { return 1e-3 * i; }));
}
inline rc::Gen<double> gaps() { return rc::gen::oneOf(rc::gen::element(0.0, 1e-300, 1e-16), decades(-12, 12)); }

template <class Enum>
rc::Gen<Enum> any_of() {
  return rc::gen::map(rc::gen::inRange<std::size_t>(0, names_of<Enum>().size()),
                      [](std::size_t i) { return static_cast<Enum>(i); });
}

/// Which solver the tuples are for.
enum class Solver { any, linear, nonlinear, hard, fixed_step };

inline Law drawn_law(Solver solver) {
  if (solver == Solver::linear || solver == Solver::hard) return Law::hooke;
  const auto other = rc::gen::element(Law::hertz, Law::hertz_kuwabara_kono, Law::taguchi, Law::power);
  if (solver == Solver::nonlinear) return *other;
  return *rc::gen::weightedOneOf<Law>({{3, rc::gen::just(Law::hooke)}, {1, other}});
}

inline void draw_integrator(Parameters& p, Solver solver) {
  if (p.method == Method::ed || solver == Solver::linear || solver == Solver::nonlinear) return;
  if (solver == Solver::any && *rc::gen::inRange(0, 8) < 7) return;
  p.integrator = *rc::gen::element(Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog);
  p.steps_per_tc = *rc::gen::oneOf(rc::gen::just(0), rc::gen::inRange(2, 200));
  p.tolerance = *decades(-5, -2);
}

/// Damping ratios from weak to well overdamped, or a restitution.
inline void draw_stiffness(Parameters& p) {
  if (p.law == Law::hooke && *rc::gen::inRange(0, 3) == 2) {
    p.K_over_m = *decades(2, 14);
    const double ratio = *rc::gen::oneOf(rc::gen::element(0.0, 1.0 - 1e-12, 1.0, 1.0 + 1e-12), decades(-4, 2));
    const double most = p.method == Method::ed ? 0.999 : ratio;  // hard spheres come apart
    p.D_n = std::min(ratio, most) * std::sqrt(p.K_over_m);
  } else {
    p.tc = *decades(-9, 1);
    p.epsilon = *epsilons();
  }
}

inline Parameters drawn(Solver solver, int max_beads = 30) {
  Parameters p;
  p.method = solver == Solver::hard                                  ? Method::ed
             : solver == Solver::any && *rc::gen::inRange(0, 3) == 2 ? Method::ed
                                                                     : Method::md;
  p.law = p.method == Method::ed ? Law::hooke : drawn_law(solver);
  if (p.law == Law::power) {
    p.beta = 0.125 * *rc::gen::inRange(0, 13);
    p.gamma = 0.125 * *rc::gen::inRange(0, 9);
  }
  p.tolerance = *decades(-12, -2);
  draw_integrator(p, solver);
  const bool slow = p.law != Law::hooke || p.integrator != Integrator::exact;
  p.N = *rc::gen::inRange(1, slow ? 9 : max_beads + 1);
  p.wall = *any_of<Wall>();
  p.ed_rule = p.method == Method::ed ? *any_of<EdRule>() : EdRule::lrv;
  p.v0 = *decades(-15, 3);
  p.seed = *rc::gen::inRange(0, 1000);
  p.random_separation = *any_of<Flag>();
  if (*rc::gen::inRange(0, 3) == 2) p.width = p.d * 0.01 * *rc::gen::inRange(0, 200);
  draw_stiffness(p);
  p.sigma = *gaps();
  return completed(p);
}

}  // namespace sigmasweep::any_parameters
