#include "bench/peers/odeint_plain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>

#include "bench/peers/equations.hpp"

namespace sigmasweep::peers {
namespace {

namespace odeint = boost::numeric::odeint;

/// Steps are no longer than a tenth of a contact. Tried: with longer ones errors are up to ten times larger at loose
/// tolerances, and times hardly shorter.
constexpr double longest_step = 0.1;

bool has_contact(const State& y) {
  return std::any_of(y.begin(), y.begin() + beads, [](double x) { return x > 0.0; });
}

/// The collision's eps_eff; NaN if it gives more than the energy that there was, or does not end.
template <class Stepper>
double collision(double sigma, double tolerance) {
  constexpr int most_steps = 10'000'000;
  auto solver = odeint::make_controlled(tolerance, tolerance, longest_step, Stepper());
  const WithoutEvents equations;
  State y = at_start(sigma);
  double t = 0.0, dt = longest_step;
  for (int steps = 0; steps < most_steps; ++steps) {
    if (solver.try_step(std::cref(equations), y, t, dt) == odeint::fail || has_contact(y)) continue;
    if (is_over(y, 1e-3 * tolerance)) {
      const double found = eps_eff(y);
      return found < 1.1 ? found : NAN;
    }
    // A flight: up to the next contact nothing happens.
    const double flight = std::max(0.0, time_to_closing(y));
    for (std::size_t k = 0; k < beads; ++k) y[k] += flight * y[beads + k];
    t += flight;
  }
  return NAN;
}

template <class Stepper>
void add(std::vector<Method>& methods, const std::string& name) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    methods.push_back(one_by_one(name, fmt::format("{:.0e}", tolerance), [tolerance](const Tuple& tuple) {
      return collision<Stepper>(tuple.sigma(), tolerance);
    }));
}

}  // namespace

std::vector<Method> odeint_plain_methods() {
  std::vector<Method> methods;
  add<odeint::runge_kutta_dopri5<State>>(methods, "odeint dopri5");
  add<odeint::runge_kutta_fehlberg78<State>>(methods, "odeint rkf78");
  return methods;
}

}  // namespace sigmasweep::peers
