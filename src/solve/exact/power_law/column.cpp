#include "solve/exact/power_law/column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sigmasweep {

template <class Real, class Ground>
NonlinearColumn<Real, Ground>::NonlinearColumn(const Column<Real>& column, double accuracy, const RunLimits& limits,
                                               const Ground& ground, double restitution_off)
    : Events(column.contacts(), ground),
      column_(column),
      accuracy_(accuracy),
      stop_(limits, 100'000 + 20 * column.contacts() * column.contacts(), 50'000'000),
      settle_schedule_(column.contacts(), 100 + 10 * column.contacts()),
      closing_overlap_(PowerLawGroup<Real>::closing_overlap(Real(accuracy))) {
  for (std::size_t k = 0; k < N_; ++k) x_[k] = -column.initial_gap(k);
  if constexpr (!Ground::moves) u_[0] = column.speed;
  if constexpr (can_isolate) isolated_.emplace(column_, accuracy_, restitution_off);
}

/// The clock starts when the first bead meets the wall. Beads that touch each other then are open gaps of length 0:
/// they close when the wave gets to them.
template <class Real, class Ground>
template <class Watcher>
Outcome<Real> NonlinearColumn<Real, Ground>::run(Watcher& watcher) {
  if constexpr (Watcher::observes) isolated_.reset();  // it wants to see the contacts, too
  x_[0] = closing_overlap_;
  this->regroup({0, N_ - 1}, Real(0));

  Outcome<Real> outcome;
  while (outcome.end == End::none && outcome.status == Status::ok) {
    Real t = events_.time_of(events_.first());
    if constexpr (Watcher::observes) {
      watcher.until(epoch_ + t, [this](double when, auto x, auto u) { state_at(when - epoch_, x, u); });
      if (watcher.done()) break;
    }
    if (t == std::numeric_limits<Real>::infinity()) {
      outcome.end = End::separated;
    } else if (outcome.status = t >= 0 ? why_stop() : Status::non_finite; outcome.status != Status::ok) {
      break;
    } else if (is_settled()) {
      outcome.end = End::settled;
    } else {
      if (t > longest_clock && this->nothing_touches() && !(isolated_ && isolated_->any())) {
        this->begin_anew(t);
        t = Real(0);
      }
      ++steps_;
      if (!handle_isolated(t)) this->advance(t);
    }
  }
  outcome.velocity = velocities();
  outcome.t_k = wall_opened_;
  outcome.x_max = x_max_;
  outcome.contacts = contacts_;
  return outcome;
}

template <class Real, class Ground>
Outcome<Real> NonlinearColumn<Real, Ground>::run() {
  NullObserver nobody;
  return run(nobody);
}

/// Overlaps and rates at a time between the last event and the next.
template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::state_at(const Real& t, std::span<Real> x, std::span<Real> u) {
  for (std::size_t k = 0; k < N_; ++k) {
    if (group_of_[k] != Events::none) continue;
    const ContactState<Real> now = this->free_state(k, t);
    x[k] = now.x;
    u[k] = now.u;
  }
  for (std::size_t k = 0; k < N_; ++k)
    if (const int id = group_of_[k]; id != Events::none) {
      Group& group = this->group(id);
      group.contacts.within(std::max(Real(t - group.start), Real(0)), x, u);
      k = group.hi;
    }
}

template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::advance_free(std::size_t k, const Real& t) {
  const ContactState<Real> now = this->free_state(k, t);
  x_[k] = now.x;
  u_[k] = now.u;
}

template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::change_contact(std::size_t k, const Real& t) {
  closed_[k] = !closed_[k];
  if (closed_[k]) {
    x_[k] = closing_overlap_;
    return;
  }
  ++contacts_;
  if (k == 0) wall_opened_ = epoch_ + t;
}

template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::move_group(Group& group, const Real& elapsed, bool whole_step) {
  if (whole_step) {
    x_max_ = group.contacts.deepest(x_max_);
    group.contacts.finish(x_, u_);
  } else {
    group.contacts.within(elapsed, x_, u_);
  }
  if constexpr (Ground::moves) this->work_done_ += group.contacts.plate_work();
}

template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::step_group(Group& group) {
  const std::uint64_t before = group.contacts.work();
  if (!group.contacts.step(group.start)) step_underflow_ = true;
  work_ += group.contacts.work() - before;
}

/// The next event, at time t, as far as isolated contacts have to do with it. False if it is still to be handled.
template <class Real, class Ground>
bool NonlinearColumn<Real, Ground>::handle_isolated(const Real& t) {
  if (!can_isolate || !isolated_) return false;
  const std::size_t next = events_.first();
  if (const int id = group_of_[next]; id != Events::none) {
    const auto event = event_of(this->group(id));
    return event && !closed_[*event] && interrupt_near(*event, t);
  }
  if (is_busy(next)) {
    end_isolated(next, t);
    return true;
  }
  return begin_isolated(next, t) || interrupt_near(next, t);
}

/// Gap k closes at time t: if it is isolated it takes its virtual state.
template <class Real, class Ground>
bool NonlinearColumn<Real, Ground>::begin_isolated(std::size_t k, const Real& t) {
  if constexpr (can_isolate) {
    const ContactState<Real> closing = this->free_state(k, t);
    const Real soon = isolated_->least_duration(k, closing.u);
    const auto closes_by_then = [&](std::size_t j) {
      const ContactState<Real> gap = this->free_state(j, t);
      return group_of_[j] != Events::none || gap.x + (gap.u + isolated_->share(k, j) * closing.u) * soon >= 0;
    };
    if ((k > 0 && closes_by_then(k - 1)) || (k + 1 < N_ && closes_by_then(k + 1))) return false;
    const auto becomes = isolated_->virtual_state(k, closing);
    if (!becomes) return false;
    const bool below = k == 0 || stay_open(k, k - 1, t, *becomes);
    if (!below || !(k + 1 == N_ || stay_open(k, k + 1, t, *becomes))) return false;
    for (std::size_t j = k > 0 ? k - 1 : 0; j <= std::min(k + 1, N_ - 1); ++j) this->release(j, t);
    isolated_->begin(k, closing, t);
    replace_state(k, *becomes);
    return true;
  }
  return false;
}

/// Whether the gap beside contact k, which becomes busy at t, stays open until all contacts beside it have opened. A
/// busy contact's true overlap x is not negative, so the gap's own is at most by its share of the virtual overlap above
/// the virtual one. Both are uniform until x = 0, the bound is convex: its ends decide.
template <class Real, class Ground>
bool NonlinearColumn<Real, Ground>::stay_open(std::size_t k, std::size_t beside, const Real& t,
                                              const ContactState<Real>& becomes) const {
  if constexpr (can_isolate) {
    if (group_of_[beside] != Events::none || is_busy(beside)) return false;
    const ContactState<Real> gap = this->free_state(beside, t), closing = this->free_state(k, t);
    const Real share = isolated_->share(k, beside), duration = becomes.x / -becomes.u;
    const Real x = gap.x + share * (closing.x - becomes.x), u = gap.u + share * (closing.u - becomes.u);
    ContactState<Real> other{};
    Real other_share = 0, end = duration;
    const std::size_t beyond = 2 * beside - k;  // wraps round below 0
    if (beyond < N_ && is_busy(beyond)) {
      other = this->free_state(beyond, t);
      other_share = isolated_->share(beyond, beside);
      end = std::max(end, Real(other.x / -other.u));
    }
    const auto bound = [&](const Real& s) {
      return x + u * s + share * std::max(Real(becomes.x + becomes.u * s), Real(0)) +
             other_share * std::max(Real(other.x + other.u * s), Real(0));
    };
    return bound(Real(0)) < 0 && bound(end) < 0;
  }
  return false;
}

template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::end_isolated(std::size_t k, const Real& t) {
  this->release(k, t);
  x_[k] = Real(0);
  x_max_ = std::max(x_max_, Real(isolated_->end(k)));
  ++contacts_;
  if (k == 0) wall_opened_ = epoch_ + t;
  this->schedule_gap(k);
}

/// Contact k is to close at time t, and is not isolated: busy contacts that share a gap with it, or with such ones, are
/// moved by steps from now on. False if there are none.
template <class Real, class Ground>
bool NonlinearColumn<Real, Ground>::interrupt_near(std::size_t k, const Real& t) {
  if constexpr (can_isolate) {
    std::size_t lo = k, hi = k;  // contacts that are not isolated, and no busy one beside or between them
    const auto take = [&](std::size_t b) {
      if (!is_busy(b)) return false;
      for (std::size_t j = b > 0 ? b - 1 : 0; j <= std::min(b + 1, N_ - 1); ++j) this->release(j, t);
      const ContactState<Real> now = isolated_->true_state(b, t);
      const Real deepest = isolated_->end(b);
      if (now.u < 0) x_max_ = std::max(x_max_, deepest);
      replace_state(b, now);
      closed_[b] = 1;
      return true;
    };
    for (bool found = true; found;) {
      found = false;
      for (const std::size_t distance : {std::size_t(1), std::size_t(2)}) {
        if (lo >= distance && take(lo - distance)) lo -= distance, found = true;
        if (hi + distance < N_ && take(hi + distance)) hi += distance, found = true;
      }
    }
    if (lo == k && hi == k) return false;
    typename Events::Range range{lo > 0 ? lo - 1 : 0, std::min(hi + 1, N_ - 1)};
    for (std::size_t j = range.lo; j <= range.hi; ++j) {
      const auto released = this->release(j, t);
      range = {std::min(range.lo, released.lo), std::max(range.hi, released.hi)};
    }
    this->regroup(range, t);
    return true;
  }
  return false;
}

/// Of contact k and the gaps beside it, all at the same time: the beads keep their momenta, and where they would be.
template <class Real, class Ground>
void NonlinearColumn<Real, Ground>::replace_state(std::size_t k, const ContactState<Real>& state) {
  for (std::size_t j = k > 0 ? k - 1 : 1; j <= k + 1 && j < N_; j += 2) {
    const Real share = isolated_->share(k, j);
    x_[j] += share * (x_[k] - state.x);
    u_[j] += share * (u_[k] - state.u);
    this->schedule_gap(j);
  }
  x_[k] = state.x;
  u_[k] = state.u;
  this->schedule_gap(k);
}

template <class Real, class Ground>
bool NonlinearColumn<Real, Ground>::is_settled() {
  if (isolated_ && isolated_->any()) return false;  // what they dissipate is over, they are not
  if (!settle_schedule_.is_due(contacts_, steps_)) return false;
  return EnergyBalance<Real>(column_, closed_, x_, velocities()).remaining() < Real(stop_.settle());
}

template <class Real, class Ground>
PlateWork NonlinearColumn<Real, Ground>::work_of(Group& group, const Real& elapsed) requires(Ground::moves) {
  std::vector<Real> x(x_), u(u_);
  group.contacts.within(elapsed, x, u);
  return group.contacts.plate_work();
}

template <class Real, class Ground>
Status NonlinearColumn<Real, Ground>::why_stop() {
  return step_underflow_ ? Status::non_finite : stop_.why_stop(contacts_, work_, N_);
}

template class NonlinearColumn<double>;
template class NonlinearColumn<long double>;
template class NonlinearColumn<double, Plate>;
template Outcome<double> NonlinearColumn<double>::run(Samples&);

}  // namespace sigmasweep
