#include "bench/peers/odeint_events.hpp"

#include <fmt/format.h>

#include <boost/numeric/odeint.hpp>
#include <functional>

namespace sigmasweep::peers {
namespace {

namespace odeint = boost::numeric::odeint;

class Dopri5 {
 public:
  explicit Dopri5(double tolerance)
      : solver_(odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<State>())) {}

  std::size_t next_event(BetweenTwoEvents& now, const Closed& closed) {
    constexpr int most_steps = 100'000;
    equations_.closed = closed;
    solver_.initialize(now.y, now.t, now.step);
    const auto at = [this](double t, State& y) { solver_.calc_state(t, y); };
    for (int steps = 0; steps < most_steps; ++steps) {
      const auto [t0, t1] = solver_.do_step(std::cref(equations_));
      const EventSearch search(closed, t0, solver_.previous_state(), t1, solver_.current_state(), at);
      const auto event = search.first();
      if (!event) continue;
      now = {.y = {}, .t = event->time, .step = solver_.current_time_step()};
      solver_.calc_state(event->time, now.y);
      return event->contact;
    }
    return beads;
  }

 private:
  odeint::result_of::make_dense_output<odeint::runge_kutta_dopri5<State>>::type solver_;
  BetweenEvents equations_;
};

}  // namespace

Collision odeint_with_events(double sigma, double tolerance) {
  Dopri5 solver(tolerance);
  return collision_with_events(solver, sigma, 1e-3 * tolerance);
}

std::vector<Method> odeint_event_methods() {
  std::vector<Method> methods;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    methods.push_back(
        one_by_one("odeint dopri5, events", fmt::format("{:.0e}", tolerance),
                   [tolerance](const Tuple& t) { return odeint_with_events(t.sigma(), tolerance).eps_eff; }));
  return methods;
}

}  // namespace sigmasweep::peers
