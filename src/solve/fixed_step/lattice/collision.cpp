#include "solve/fixed_step/lattice/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/lattice.hpp"
#include "solve/fixed_step/dispatch.hpp"
#include "solve/fixed_step/lattice/system.hpp"
#include "solve/observer/lattice_samples.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t steps_between_checks = 16, steps_between_outlooks = 64;
constexpr double max_work = 1e10;  // steps times beads of a collision: some minutes

/// Steps a lattice from the start to the end of a collision and keeps the record, as Run (fixed_step.cpp) does a
/// column. Watcher: NullObserver or LatticeSamples.
template <class Steps, class Watcher>
class LatticeRun {
 public:
  LatticeRun(const Lattice<double>& lattice, double dt, const LatticeOptions& options, FreeFlight free_flight,
             Watcher& watcher)
      : lattice_(lattice),
        options_(options),
        dt_(dt),
        free_flight_(free_flight),
        steps_(lattice, dt),
        watcher_(watcher) {
    const auto N = static_cast<double>(lattice.count());
    if (options_.event_limit == 0) options_.event_limit = 100'000 + 1'000 * lattice.count();
    step_limit_ = (options_.work_limit == 0 ? max_work : static_cast<double>(options_.work_limit)) / N;
    quiet_ = lattice.quiet_time() / dt;
    lowest_energy_ = start_energy_ = steps_.energy();
  }

  LatticeOutcome<double> operator()() {
    for (std::uint64_t made = 1; is_on(); ++made) {
      if (!any_closed_ && steps_.scheme().coasts()) cross_free_flight();
      if (!is_on()) break;
      advance();
      if (made % steps_between_checks == 0) check();
      if (made % steps_between_outlooks == 0 && is_on()) look_ahead();
      if (outcome_.contacts > options_.event_limit || static_cast<double>(made) > step_limit_)
        give_up(Status::event_limit);
      if constexpr (Watcher::observes)
        if (watcher_.done()) break;
    }
    if constexpr (Watcher::observes)
      if (outcome_.end != End::none) show_free_flight();
    check_energy();
    return result();
  }

 private:
  bool is_on() const { return outcome_.status == Status::ok && outcome_.end == End::none; }
  void give_up(Status why) {
    if (outcome_.status == Status::ok) outcome_.status = why;
  }
  void finish(End end, double remainder = 0.0) {
    outcome_.end = end;
    outcome_.remainder = remainder;
  }

  void advance() {
    remember();
    steps_.scheme().step();
    now_ += 1.0;
    show(1.0);
    const ContactChanges changes = steps_.contacts().look([&](double before, double x) {
      const double when = now_ - x / (x - before);  // linear interpolation
      if (x > 0.0 && first_touch_ < 0.0) first_touch_ = when;
      last_touch_ = when;
    });
    any_closed_ = changes.any_closed;
    outcome_.contacts += changes.opened;
    if (any_closed_) last_closed_ = now_;
    steps_.keep_lists();
    if (quiet_ > 0.0 && now_ - last_closed_ >= quiet_) finish(End::quiet);
  }

  /// What the contacts on the lists say: how long none of them closes, as distances are convex functions of time; the
  /// energy of those that are closed or approach, and how much of it they can lose.
  struct Prospect {
    bool closed = false, approaches = false;
    double steps = std::numeric_limits<double>::infinity();
    double held = 0.0, approaching = 0.0, loss = 0.0;
  };
  Prospect prospect() {
    Prospect p;
    steps_.contacts().each(steps_.scheme().x(), steps_.scheme().u(),
                           [&](double overlap, double rate, double speed, double elastic, double inertia, double eps) {
                             if (overlap > 0.0) {
                               p.closed = true;
                               p.held += 0.5 * (elastic + speed * speed / inertia);
                               p.loss += 0.5 * (elastic + speed * speed / inertia);
                             } else if (rate > 0.0) {
                               p.approaches = true;
                               p.steps = std::min(p.steps, -overlap / rate);
                               p.approaching += 0.5 * rate * rate / inertia;
                               p.loss += 0.5 * rate * rate / inertia * (1.0 - eps * eps);
                             }
                           });
    return p;
  }

  void cross_free_flight() {
    const Prospect p = prospect();
    if (p.closed) return;
    if (quiet_ == 0.0 && is_over(p)) return;
    double steps = std::min(p.steps, steps_.steps_within_lists());
    if (quiet_ > 0.0) steps = std::min(steps, last_closed_ + quiet_ - now_);
    if (!(steps >= 2.0) || free_flight_ == FreeFlight::stepped) return;
    steps = std::floor(steps) - 1.0;
    remember();
    steps_.scheme().coast(steps);
    now_ += steps;
    show(steps);
    steps_.keep_lists();
  }

  /// d eps_eff = dE/(2 eps_eff E0), eps_eff^2 = E/E0
  double per_energy() const { return 0.5 / std::sqrt(steps_.energy() * start_energy_); }

  /// Without a gap.
  bool is_over(const Prospect& p) {
    if (!p.closed && !p.approaches) {
      finish(End::separated);
      return true;
    }
    if (!((p.held + p.approaching) * per_energy() < options_.settle)) return false;  // elastic beads come apart, too
    finish(End::settled, p.loss * per_energy());
    return true;
  }
  void look_ahead() {
    const Prospect p = prospect();
    if (quiet_ == 0.0) {
      is_over(p);
    } else if (const double held = p.held * per_energy(); held >= options_.settle) {
      last_lively_ = now_;
    } else if (p.closed && now_ - last_lively_ >= quiet_) {
      finish(End::settled, held);  // overdamped beads that stick for good are quiet, too
    }
  }

  void check() {
    check_energy();
    if (options_.budget && options_.budget->is_over(steps_between_checks * steps_.contacts().size()))
      give_up(Status::time_limit);
  }

  /// As Run does.
  void check_energy() {
    const double E = steps_.energy();
    if (!(E <= lowest_energy_ + 0.05 * start_energy_)) give_up(Status::unstable);
    lowest_energy_ = std::min(lowest_energy_, E);
    // What beads that creep and stick for good have left.
    const double all = std::sqrt(E / start_energy_);
    if (is_on() && all < options_.settle) finish(End::settled, all);
  }

  void remember() {
    if constexpr (Watcher::observes) steps_.remember();
  }
  void show(double steps) {
    if constexpr (Watcher::observes)
      watcher_.until(now_ * dt_,
                     [&](double t, auto q, auto v) { steps_.between(1.0 - (now_ - t / dt_) / steps, steps, q, v); });
  }
  /// What is left of the samples when it is over.
  void show_free_flight() {
    watcher_.until(std::numeric_limits<double>::infinity(), [&](double t, auto q, auto v) {
      for (std::size_t i = 0; i < lattice_.count(); ++i) {
        q[i] = steps_.q(i) + (t / dt_ - now_) * steps_.u(i);
        v[i] = 1.0 / dt_ * steps_.u(i);
      }
    });
  }

  LatticeOutcome<double> result() {
    for (std::size_t i = 0; i < lattice_.count(); ++i) outcome_.velocity.push_back(1.0 / dt_ * steps_.u(i));
    outcome_.x_max = steps_.contacts().deepest();
    outcome_.t_k = (last_touch_ - std::max(first_touch_, 0.0)) * dt_;
    return outcome_;
  }

  const Lattice<double>& lattice_;
  LatticeOptions options_;
  double dt_;
  FreeFlight free_flight_;
  Steps steps_;
  Watcher& watcher_;
  double now_ = 0.0;  ///< time in steps, crossed ones included
  double step_limit_ = 0.0, quiet_ = 0.0;
  double first_touch_ = -1.0, last_touch_ = 0.0;  ///< of the bottom
  double last_closed_ = 0.0, last_lively_ = 0.0;
  double start_energy_ = 0.0, lowest_energy_ = 0.0;
  bool any_closed_ = false;
  LatticeOutcome<double> outcome_;
};

template <class Watcher>
LatticeOutcome<double> watched_by(Watcher& watcher, const Lattice<double>& lattice, Integrator integrator, double dt,
                                  const LatticeOptions& options, FreeFlight free_flight = FreeFlight::skipped) {
  return with_law(lattice.beads, [&]<class Force, bool Uneven>() {
    return with_scheme(integrator, [&]<template <class> class Scheme>() {
      return LatticeRun<LatticeSteps<Force, Uneven, Scheme, FixedWall>, Watcher>(lattice, dt, options, free_flight,
                                                                                 watcher)();
    });
  });
}

}  // namespace

LatticeOutcome<double> fixed_step_lattice_collision(const Lattice<double>& lattice, Integrator integrator, double dt,
                                                    const LatticeOptions& options) {
  return fixed_step_lattice_collision(lattice, integrator, dt, options, FreeFlight::skipped);
}

LatticeOutcome<double> fixed_step_lattice_collision(const Lattice<double>& lattice, Integrator integrator, double dt,
                                                    const LatticeOptions& options, FreeFlight free_flight) {
  NullObserver nobody;
  return watched_by(nobody, lattice, integrator, dt, options, free_flight);
}

void observe_fixed_step_lattice(const Lattice<double>& lattice, Integrator integrator, double dt,
                                LatticeSamples& samples) {
  watched_by(samples, lattice, integrator, dt, {.settle = 0.0});
}

}  // namespace sigmasweep
