#include "solve/fixed_step/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/energy_balance.hpp"
#include "solve/fixed_step/dispatch.hpp"
#include "solve/observer/samples.hpp"

namespace sigmasweep {

namespace {

/// Steps a scheme from the start to the end of a collision and keeps the record. Watcher: NullObserver or Samples, with
/// whose last sample it may end.
template <class Chain, template <class> class Scheme, class Watcher>
class Run {
 public:
  Run(const Column<double>& column, double dt, const FixedStepOptions& options, Watcher& watcher)
      : column_(column),
        options_(options),
        dt_(dt),
        chain_(column, dt),
        scheme_(chain_),
        before_(chain_.x),
        deepest_(chain_.contacts),
        watcher_(watcher) {
    if (options_.step_limit == 0.0) options_.step_limit = 1e11 / static_cast<double>(column.N);
    lowest_energy_ = start_energy_ = energy();
  }

  Outcome<double> operator()() {
    while (outcome_.status == Status::ok && outcome_.end == End::none) {
      if (!any_closed_ && scheme_.coasts()) cross_free_flight();
      if (outcome_.end != End::none) break;
      advance();
      if (++steps_ % 16 == 0) {
        check_energy();
        if (options_.budget && options_.budget->is_over(16 * chain_.contacts) && outcome_.status == Status::ok)
          outcome_.status = Status::time_limit;
      }
      if (steps_ % 65536 == 0) check_creep();
      if (static_cast<double>(steps_) > options_.step_limit && outcome_.status == Status::ok)
        outcome_.status = Status::event_limit;
      if constexpr (Watcher::observes)
        if (watcher_.done()) break;
    }
    if constexpr (Watcher::observes)
      if (outcome_.end != End::none) show_free_flight();
    if (outcome_.status == Status::ok) check_energy();
    return result();
  }

 private:
  void advance() {
    remember_rates();
    scheme_.step();
    now_ += 1.0;
    show(1.0);
    const double* x = scheme_.x();
    double* before = before_.data();
    double* deepest = deepest_.data();
    if ((x[0] > 0.0) != (before[0] > 0.0)) wall_changed(x[0]);
    const std::size_t lanes = chain_.lanes();
    std::int64_t closed = 0, opened = 0;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      closed |= x[k] > 0.0;
      opened += (before[k] > 0.0) & !(x[k] > 0.0);
      deepest[k] = x[k] > deepest[k] ? x[k] : deepest[k];
      before[k] = x[k];
    }
    any_closed_ = closed != 0;
    outcome_.contacts += static_cast<std::uint64_t>(opened);
  }

  /// When the wall's contact closed or opened, by linear interpolation within the step just done.
  void wall_changed(double x) {
    const double before = before_[0];
    const double when = now_ - x / (x - before);
    if (x > 0.0 && first_wall_ < 0.0) first_wall_ = when;
    last_wall_ = when;
  }

  /// No contact is closed and the rates are constant: see whether it is over, and if not go to the last step before
  /// the next contact closes.
  void cross_free_flight() {
    double steps = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < chain_.contacts; ++k)
      if (scheme_.u()[k] > 0.0) steps = std::min(steps, -scheme_.x()[k] / scheme_.u()[k]);
    if (steps == std::numeric_limits<double>::infinity()) {
      outcome_.end = End::separated;
      return;
    }
    if (steps < 2.0) return;
    if (residual_dissipation<double>(velocities(), chain_.u[0], column_.mass) < options_.settle) {
      outcome_.end = End::settled;
      return;
    }
    if (!options_.skip_free_flight) return;
    steps = std::floor(steps) - 1.0;
    remember_rates();
    scheme_.coast(steps);
    now_ += steps;
    show(steps);
    // Only where a gap is so wide that its rounding exceeds a step.
    for (std::size_t k = 0; k < chain_.contacts; ++k)
      if (scheme_.x()[k] > 0.0) scheme_.touch(k);
    before_copy();
  }

  void remember_rates() {
    if constexpr (Watcher::observes) rates_before_.assign(scheme_.u(), scheme_.u() + chain_.contacts);
  }

  /// Shows the watcher the steps just done.
  void show(double steps) {
    if constexpr (Watcher::observes)
      watcher_.until(now_ * dt_, [&](double t, auto x, auto u) {
        for (std::size_t k = 0; k < chain_.contacts; ++k) {
          const BetweenSteps now(1.0 - (now_ - t / dt_) / steps, steps, before_[k], rates_before_[k], scheme_.x()[k],
                                 scheme_.u()[k]);
          x[k] = now.x;
          u[k] = now.u / dt_;
        }
      });
  }

  /// What is left of the samples when it is over.
  void show_free_flight() {
    watcher_.until(std::numeric_limits<double>::infinity(), [&](double t, auto x, auto u) {
      for (std::size_t k = 0; k < chain_.contacts; ++k) {
        x[k] = scheme_.x()[k] + scheme_.u()[k] * (t / dt_ - now_);
        u[k] = scheme_.u()[k] / dt_;
      }
    });
  }

  void before_copy() { std::copy_n(scheme_.x(), chain_.contacts, before_.data()); }

  /// v_k = -(u_0 + ... + u_k), lengths a step.
  std::vector<double> velocities() const {
    std::vector<double> v(chain_.contacts);
    double sum = 0.0;
    for (std::size_t k = 0; k < chain_.contacts; ++k) v[k] = -(sum += scheme_.u()[k]);
    return v;
  }

  double energy() const {
    double v = 0.0, E = 0.0;
    for (std::size_t k = 0; k < chain_.contacts; ++k) {
      const double x = scheme_.x()[k];
      v += scheme_.u()[k];
      E += column_.mass.empty() ? v * v : column_.mass[k] * v * v;
      if (x > 0.0) E += chain_.force.elastic(chain_.K[k], x);
    }
    return 0.5 * E;
  }

  /// Energy can only fall. If it rises again by 5 % of what there was at the start, or beyond all numbers, then that
  /// is the scheme's doing.
  void check_energy() {
    const double E = energy();
    if (!(E <= lowest_energy_ + 0.05 * start_energy_)) outcome_.status = Status::unstable;
    lowest_energy_ = std::min(lowest_energy_, E);
  }

  /// Overdamped beads that creep, and stick together for good, end by how little they have left to lose.
  void check_creep() {
    std::vector<std::uint8_t> closed(chain_.contacts);
    for (std::size_t k = 0; k < chain_.contacts; ++k) closed[k] = scheme_.x()[k] > 0.0;
    std::vector<double> v = velocities();
    for (double& each : v) each /= dt_;
    const EnergyBalance<double> energy(column_, closed, {scheme_.x(), chain_.contacts}, std::move(v));
    if (energy.remaining() < options_.settle) outcome_.end = End::settled;
  }

  Outcome<double> result() {
    if (options_.steps) *options_.steps = steps_;
    outcome_.velocity = velocities();
    for (double& v : outcome_.velocity) v /= dt_;
    for (std::size_t k = 0; k < chain_.contacts; ++k) outcome_.x_max = std::max(outcome_.x_max, deepest_[k]);
    outcome_.t_k = (last_wall_ - std::max(first_wall_, 0.0)) * dt_;
    return outcome_;
  }

  const Column<double>& column_;
  FixedStepOptions options_;
  double dt_;
  Chain chain_;
  Scheme<Chain> scheme_;
  AlignedLanes before_, deepest_;
  Watcher& watcher_;
  std::vector<double> rates_before_;  ///< for the watcher
  double now_ = 0.0;                  ///< time in steps, crossed ones included
  double first_wall_ = -1.0, last_wall_ = 0.0;
  double start_energy_ = 0.0, lowest_energy_ = 0.0;
  std::uint64_t steps_ = 0;
  bool any_closed_ = false;
  Outcome<double> outcome_;
};

template <class Watcher>
Outcome<double> watched_by(Watcher& watcher, const Column<double>& column, Integrator integrator, double dt,
                           const FixedStepOptions& options) {
  return with_law(column, [&]<class Force, bool Uneven>() {
    return with_scheme(integrator, [&]<template <class> class Scheme>() {
      return Run<Chain<Force, Uneven>, Scheme, Watcher>(column, dt, options, watcher)();
    });
  });
}

}  // namespace

Outcome<double> fixed_step_collision(const Column<double>& column, Integrator integrator, double dt,
                                     const FixedStepOptions& options) {
  NullObserver nobody;
  return watched_by(nobody, column, integrator, dt, options);
}

void observe_fixed_step(const Column<double>& column, Integrator integrator, double dt, Samples& samples) {
  watched_by(samples, column, integrator, dt, {.settle = 0.0});  // to the last sample
}

}  // namespace sigmasweep
