#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <optional>

#include "bench/peers/equations.hpp"

/// Where contacts open and close within a step of a solver with dense output.
namespace sigmasweep::peers {

struct Event {
  double time;
  std::size_t contact;
};

/// The first event of the step from (t0, y0) to (t1, y1). `at(t, y)` is the solver's dense output.
///
/// A contact k has an event if its overlap's sign at t1 is not that of its state, closed or open. It may also have two,
/// between which x_k has an extremum: looked for if the rates at t0 and t1 have opposite signs and the tangent at t0
/// reaches 0. Roots are found by TOMS 748. A contact that has just opened or closed has x_k(t0) = 0: the root of
/// x_k(t)/(t - t0), which begins at x_k'(t0), is the next one.
template <class DenseOutput>
class EventSearch {
 public:
  EventSearch(const Closed& closed, double t0, const State& y0, double t1, const State& y1, const DenseOutput& at)
      : closed_(closed), t0_(t0), t1_(t1), y0_(y0), y1_(y1), at_(at) {}

  std::optional<Event> first() const {
    std::optional<Event> found;
    for (std::size_t k = 0; k < beads; ++k)
      if (const auto end = after_event(k))
        if (const double t = event_before(k, *end); !found || t < found->time) found = Event{t, k};
    return found;
  }

 private:
  double sign(std::size_t k) const { return closed_[k] > 0.0 ? 1.0 : -1.0; }
  double component(std::size_t i, double t) const {
    State y;
    at_(t, y);
    return y[i];
  }

  /// A time at which the contact is on the wrong side of 0; none if it stays on the right one.
  std::optional<double> after_event(std::size_t k) const {
    if (sign(k) * y1_[k] < 0.0) return t1_;
    const double u0 = sign(k) * y0_[beads + k], u1 = sign(k) * y1_[beads + k];
    const bool may_touch = u0 < 0.0 && u1 > 0.0 && sign(k) * y0_[k] + u0 * (t1_ - t0_) < 0.0;
    if (!may_touch) return {};
    const double t = root([&](double s) { return component(beads + k, s); }, t0_, y0_[beads + k], t1_, y1_[beads + k]);
    if (sign(k) * component(k, t) < 0.0) return t;
    return {};
  }

  double event_before(std::size_t k, double end) const {
    const double x0 = y0_[k], x1 = end == t1_ ? y1_[k] : component(k, end);
    if (sign(k) * x0 < 0.0) return t0_;  // by rounding, at a tie
    if (x0 != 0.0) return root([&](double t) { return component(k, t); }, t0_, x0, end, x1);
    const double slope = y0_[beads + k], mean = x1 / (end - t0_);
    if (!(slope * mean < 0.0)) return t0_;
    const auto divided = [&](double t) { return t > t0_ ? component(k, t) / (t - t0_) : slope; };
    return root(divided, t0_, slope, end, mean);
  }

  template <class Function>
  static double root(const Function& f, double a, double fa, double b, double fb) {
    std::uintmax_t iterations = 60;
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(52), iterations);
    return 0.5 * (low + high);
  }

  const Closed& closed_;
  double t0_, t1_;
  const State &y0_, &y1_;
  const DenseOutput& at_;
};

}  // namespace sigmasweep::peers
