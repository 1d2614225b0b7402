#pragma once

#include <cstddef>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energy_on_plate.hpp"
#include "assembly/ground.hpp"
#include "solve/exact/event_loop.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// A column's contact events above the ground: a fixed wall, which needs nothing more, or a plate that vibrates.
template <class Solver, class Real, class Group, int Tangents, class Ground>
class GroundEvents : public ContactEvents<Solver, Real, Group, Tangents> {
 protected:
  GroundEvents(std::size_t contacts, const Ground& ground)
      : ContactEvents<Solver, Real, Group, Tangents>(contacts), ground_(ground) {}

  /// Of contact k, in no group, at time t.
  ContactState<Real> free_state(std::size_t k, const Real& t) const {
    return {this->x_[k] + this->u_[k] * (t - this->at_[k]), this->u_[k]};
  }
  /// How long it stays open, if it closes at `overlap`.
  Real closes_at(std::size_t k, const Real& overlap) const { return this->closes_uniformly(k, overlap); }

  [[no_unique_address]] Ground ground_;
};

/// Of the Solver this wants, besides what ContactEvents does:
///     PlateWork work_of(Group&, elapsed)       from the start of the group's step to `elapsed` later
///     void state_at(t, x, u)                   of all contacts
///     Status why_stop()                        ok: go on
///     column_                                  masses over the mean bead's
template <class Solver, class Group>
class GroundEvents<Solver, double, Group, 0, Plate> : public ContactEvents<Solver, double, Group> {
  using Events = ContactEvents<Solver, double, Group>;

 public:
  /// All periods that the watcher (VibrationStatistics says what one is) wants. Outcome: x_max, contacts, end, status.
  template <class Watcher>
  Outcome<double> follow(Watcher& watcher) {
    const auto state = [this](double t, auto x, auto u) { solver().state_at(t, x, u); };
    Outcome<double> outcome;
    this->regroup({0, N_ - 1}, 0.0);
    const double period = ground_.period(), energy = energy_at(0.0);
    while (!watcher.done() && outcome.status == Status::ok) {
      const double t = events_.time_of(events_.first());
      watcher.until(std::min(t, period), state);
      if (t > period) {
        const PlateWork work = work_until(period);
        watcher.end_period(energy_at(period) - energy, work.in, work.lost);
        begin_period();
        continue;
      }
      outcome.status = t >= -period ? solver().why_stop() : Status::non_finite;
      if (outcome.status == Status::ok) this->advance(t);
    }
    if (outcome.status == Status::ok) {
      outcome.end = End::periods;
      for (std::size_t k = 0; k < N_; ++k) this->release(k, 0.0);  // overlaps of the present steps count, too
    }
    outcome.x_max = this->x_max_;
    outcome.contacts = this->contacts_;
    return outcome;
  }

 protected:
  GroundEvents(std::size_t contacts, const Plate& plate) : Events(contacts), ground_(plate) {
    static_assert(
        requires(Solver & s, Group & group, double t) {
          { s.work_of(group, t) } -> std::same_as<PlateWork>;
        },
        "work_of()");
    static_assert(
        requires(Solver & s, double t, std::span<double> x) { s.state_at(t, x, x); }, "state_at()");
    static_assert(
        requires(Solver & s) {
          { s.why_stop() } -> std::same_as<Status>;
        },
        "why_stop()");
    static_assert(
        requires(Solver & s) { s.column_; }, "column_");
  }

  using Events::N_, Events::at_, Events::closed_, Events::group_of_, Events::epoch_, Events::events_;

  ContactState<double> free_state(std::size_t k, double t) const {
    const double elapsed = t - at_[k];
    if (k == 0) return ground_.flight(this->state(0), at_[0], elapsed);
    return {this->x_[k] + this->u_[k] * elapsed, this->u_[k]};
  }
  double closes_at(std::size_t k, double overlap) const {
    if (k == 0) return ground_.landing({this->x_[0] - overlap, this->u_[0]}, at_[0]);
    return this->closes_uniformly(k, overlap);
  }

  Plate ground_;
  PlateWork work_done_;  ///< without the groups' present steps

 private:
  Solver& solver() { return static_cast<Solver&>(*this); }

  bool begins_group(std::size_t k) const {
    return group_of_[k] != Events::none && (k == 0 || group_of_[k] != group_of_[k - 1]);
  }

  PlateWork work_until(double t) {
    PlateWork work = work_done_;
    for (std::size_t k = 0; k < N_; ++k)
      if (begins_group(k)) {
        Group& group = Events::group(group_of_[k]);
        work += solver().work_of(group, t - group.start);
      }
    return work;
  }

  /// The clock goes back by a period, so that the phase stays as exact as it was.
  void begin_period() {
    const double period = ground_.period();
    for (std::size_t k = 0; k < N_; ++k) {
      at_[k] -= period;
      events_.set(k, events_.time_of(k) - period);
      if (begins_group(k)) Events::group(group_of_[k]).start -= period;
    }
    epoch_ += period;
  }

  double energy_at(double t) {
    std::vector<double> x(N_), u(N_);
    solver().state_at(t, x, u);
    return energy_on_plate(solver().column_, ground_, t, x, u);
  }
};

}  // namespace sigmasweep
