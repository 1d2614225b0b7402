#include "nonlinear_column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sigmasweep {

template <class Real>
NonlinearColumn<Real>::NonlinearColumn(const Column<Real>& column, const NonlinearOptions& options)
    : column_(column),
      options_(options),
      N_(column.contacts()),
      closing_overlap_(PowerLawGroup<Real>::closing_overlap(Real(options.accuracy))),
      u_(N_, Real(0)),
      at_(N_, Real(0)),
      closed_(N_, 0),
      group_of_(N_, none),
      events_(N_) {
  if (options_.event_limit == 0) options_.event_limit = 100'000 + 20 * N_ * N_;
  for (std::size_t k = 0; k < N_; ++k) x_.push_back(-column.initial_gap(k));
  u_[0] = column.speed;
}

/// The clock starts when the first bead meets the wall. Beads that touch each other then are open gaps of length 0:
/// they close when the wave gets to them.
template <class Real>
template <class Watcher>
Outcome<Real> NonlinearColumn<Real>::run(Watcher& watcher) {
  x_[0] = closing_overlap_;
  closed_[0] = 1;
  regroup({0, N_ - 1}, Real(0));

  Outcome<Real> outcome;
  while (outcome.end == End::none && outcome.status == Status::ok) {
    const std::size_t next = events_.first();
    const Real t = events_.time_of(next);
    if constexpr (Watcher::watches) {
      watcher.until(t, [this](double when, auto x, auto u) { state_at(when, x, u); });
      if (watcher.done()) break;
    }
    if (t == std::numeric_limits<Real>::infinity())
      outcome.end = End::separated;
    else if (lost_ || !(t >= 0))
      outcome.status = Status::non_finite;
    else if (contacts_ >= options_.event_limit || work_ >= options_.work_limit)
      outcome.status = Status::event_limit;
    else if (options_.patience && options_.patience->is_over(N_))
      outcome.status = Status::time_limit;
    else if (is_settled())
      outcome.end = End::settled;
    else
      advance(next, t);
  }
  outcome.velocity = velocities();
  outcome.t_k = wall_opened_;
  outcome.x_max = x_max_;
  outcome.contacts = contacts_;
  return outcome;
}

template <class Real>
Outcome<Real> NonlinearColumn<Real>::run() {
  Nobody nobody;
  return run(nobody);
}

/// Overlaps and rates at a time between the last event and the next.
template <class Real>
void NonlinearColumn<Real>::state_at(const Real& t, std::span<Real> x, std::span<Real> u) {
  for (std::size_t k = 0; k < N_; ++k) {
    if (group_of_[k] != none) continue;
    x[k] = x_[k] + u_[k] * (t - at_[k]);
    u[k] = u_[k];
  }
  for (std::size_t k = 0; k < N_; ++k)
    if (const int id = group_of_[k]; id != none) {
      Group& group = *groups_[std::size_t(id)];
      group.contacts.within(std::max(Real(t - group.start), Real(0)), x, u);
      k = group.hi;
    }
}

template <class Real>
void NonlinearColumn<Real>::advance(std::size_t next, const Real& t) {
  ++steps_;
  if (group_of_[next] != none)
    finish_step(group_of_[next]);
  else
    close_gap(next, t);
}

template <class Real>
void NonlinearColumn<Real>::close_gap(std::size_t k, const Real& t) {
  Range range = release(k, t);
  if (k > 0) range.lo = release(k - 1, t).lo;
  if (k + 1 < N_) range.hi = release(k + 1, t).hi;
  x_[k] = closing_overlap_;
  change_contact(k, t);
  regroup(range, t);
}

template <class Real>
void NonlinearColumn<Real>::finish_step(int id) {
  Group& group = *groups_[std::size_t(id)];
  const Real t = group.start + group.contacts.length();
  const auto event = group.contacts.event();
  x_max_ = group.contacts.deepest(x_max_);
  group.contacts.finish(x_, u_);
  group.start = t;
  if (!event) {
    begin_step(id);
    return;
  }
  change_contact(*event, t);
  const Range range{group.lo, group.hi};
  dissolve(id, t);
  regroup(range, t);
}

template <class Real>
void NonlinearColumn<Real>::change_contact(std::size_t k, const Real& t) {
  closed_[k] = !closed_[k];
  if (closed_[k]) return;
  ++contacts_;
  if (k == 0) wall_opened_ = t;
}

template <class Real>
auto NonlinearColumn<Real>::release(std::size_t k, const Real& t) -> Range {
  if (const int id = group_of_[k]; id != none) {
    const Range range{groups_[std::size_t(id)]->lo, groups_[std::size_t(id)]->hi};
    dissolve(id, t);
    return range;
  }
  x_[k] += u_[k] * (t - at_[k]);
  at_[k] = t;
  return {k, k};
}

/// Ends a group; if its step is not over yet, at a time t within it.
template <class Real>
void NonlinearColumn<Real>::dissolve(int id, const Real& t) {
  Group& group = *groups_[std::size_t(id)];
  if (group.start != t) group.contacts.within(std::max(Real(t - group.start), Real(0)), x_, u_);
  for (std::size_t k = group.lo; k <= group.hi; ++k) {
    group_of_[k] = none;
    at_[k] = t;
  }
  events_.remove(group.lo);
  idle_.push_back(id);
}

/// Sorts the contacts of `range`, all of them free of groups and at time t, into groups and free gaps, taking in
/// neighbours that a closed contact at the border touches.
template <class Real>
void NonlinearColumn<Real>::regroup(Range range, const Real& t) {
  while (closed_[range.lo] && range.lo > 0) range.lo = release(range.lo - 1, t).lo;
  while (closed_[range.hi] && range.hi + 1 < N_) range.hi = release(range.hi + 1, t).hi;
  for (std::size_t k = range.lo; k <= range.hi; ++k) {
    if (!closed_[k] && !(k < range.hi && closed_[k + 1])) {
      schedule_gap(k);
      continue;
    }
    std::size_t end = k;
    while (end < range.hi && (closed_[end] || closed_[end + 1])) ++end;
    make_group({k, end}, t);
    k = end;
  }
}

template <class Real>
void NonlinearColumn<Real>::make_group(Range range, const Real& t) {
  if (idle_.empty()) {
    idle_.push_back(int(groups_.size()));
    groups_.push_back(std::make_unique<Group>(column_, Real(options_.accuracy)));
  }
  const int id = idle_.back();
  idle_.pop_back();
  Group& group = *groups_[std::size_t(id)];
  group.lo = range.lo;
  group.hi = range.hi;
  group.start = t;
  for (std::size_t k = range.lo; k <= range.hi; ++k) {
    group_of_[k] = id;
    events_.remove(k);
  }
  group.contacts.start(range.lo, range.hi, closed_, x_, u_);
  begin_step(id);
}

template <class Real>
void NonlinearColumn<Real>::begin_step(int id) {
  Group& group = *groups_[std::size_t(id)];
  const std::uint64_t before = group.contacts.work();
  if (!group.contacts.step()) lost_ = true;
  work_ += group.contacts.work() - before;
  events_.set(group.lo, group.start + group.contacts.length());
}

template <class Real>
void NonlinearColumn<Real>::schedule_gap(std::size_t k) {
  if (u_[k] > 0)
    events_.set(k, at_[k] + std::max(Real(closing_overlap_ - x_[k]), Real(0)) / u_[k]);
  else
    events_.remove(k);
}

template <class Real>
bool NonlinearColumn<Real>::is_settled() {
  if (contacts_ < next_check_ && steps_ < next_check_step_) return false;
  next_check_ = contacts_ + std::max<std::size_t>(5, N_ / 8);
  next_check_step_ = steps_ + 100 + 10 * N_;
  return EnergyBalance<Real>(column_, closed_, x_, velocities()).remaining() < Real(options_.settle);
}

/// v_i from the rates: u_0 = -v_1 at the wall, u_k = v_k - v_(k+1) between beads.
template <class Real>
std::vector<Real> NonlinearColumn<Real>::velocities() const {
  std::vector<Real> v(N_);
  Real sum = 0;
  for (std::size_t k = 0; k < N_; ++k) v[k] = sum -= u_[k];
  return v;
}

template class NonlinearColumn<double>;
template class NonlinearColumn<long double>;
template Outcome<double> NonlinearColumn<double>::run(Samples&);

}  // namespace sigmasweep
