#include "solve/exact/power_law/column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sigmasweep {

template <class Real, class Ground>
NonlinearColumn<Real, Ground>::NonlinearColumn(const Column<Real>& column, double accuracy, const RunLimits& limits,
                                               const Ground& ground)
    : Events(column.contacts(), ground),
      column_(column),
      accuracy_(accuracy),
      stop_(limits, 100'000 + 20 * column.contacts() * column.contacts(), 50'000'000),
      settle_schedule_(column.contacts(), 100 + 10 * column.contacts()),
      closing_overlap_(PowerLawGroup<Real>::closing_overlap(Real(accuracy))) {
  for (std::size_t k = 0; k < N_; ++k) x_[k] = -column.initial_gap(k);
  if constexpr (!Ground::moves) u_[0] = column.speed;
}

/// The clock starts when the first bead meets the wall. Beads that touch each other then are open gaps of length 0:
/// they close when the wave gets to them.
template <class Real, class Ground>
template <class Watcher>
Outcome<Real> NonlinearColumn<Real, Ground>::run(Watcher& watcher) {
  x_[0] = closing_overlap_;
  closed_[0] = 1;
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
      if (t > longest_clock && this->nothing_touches()) {
        this->begin_anew(t);
        t = Real(0);
      }
      ++steps_;
      this->advance(t);
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

template <class Real, class Ground>
bool NonlinearColumn<Real, Ground>::is_settled() {
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
