#pragma once

#include <algorithm>

#include <boost/math/quadrature/gauss.hpp>

#include "solve/exact/linear/column.hpp"
#include "solve/exact/linear/column_error_impl.hpp"
#include "solve/exact/linear/load_series.hpp"

/// Definitions of ExactColumn's members. Included by the sources that instantiate it only: column_double.cpp and so on,
/// one a number type, so that they compile side by side.

namespace sigmasweep {

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::ExactColumn(const Column<Real>& column,
                                                                          const RunLimits& limits, const Ground& ground)
    : Events(column.contacts(), ground),
      column_(column),
      stop_(limits, 100'000 + 20 * column.contacts() * column.contacts(), 100'000'000),
      settle_schedule_(column.contacts(), 1000),
      laws_(column),
      steps_(column) {
  settle_schedule_.note_look(0, 0);
  for (std::size_t k = 1; k < N_; ++k) x_[k] = -column.initial_gap(k);  // the wall's only shifts the clock
  if constexpr (Ground::moves) {                                        // at rest relative to the plate
    x_[0] = -column.initial_gap(0);
  } else {
    u_[0] = column.speed;
    closed_[closed_count_++] = 1;
  }
  while (closed_count_ < N_ && x_[closed_count_] == Real(0)) closed_[closed_count_++] = 1;
  disturb_gaps();
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::start_from(std::span<const Real> rates) {
  closed_.assign(N_, 0);
  closed_count_ = 0;
  x_[0] = -column_.initial_gap(0);
  u_.assign(rates.begin(), rates.end());
}

/// The gaps are rounded numbers too: all of them the same way, as sigma is, or each for itself.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::disturb_gaps() {
  const auto& gaps = column_.gaps;
  const Real widest = gaps.empty() ? column_.gap : *std::max_element(gaps.begin(), gaps.end());
  for (int m = 1; m < motions; ++m) {
    Real change = Real(noise_.next()) * std::numeric_limits<Real>::epsilon() * widest;
    for (std::size_t k = 1; k < N_; ++k) {
      motion_[m].x[k] = change;
      if (!gaps.empty()) change = Real(noise_.next()) * std::numeric_limits<Real>::epsilon() * widest;
    }
  }
}

/// The clock starts at the first contact with the wall, after a flight of gap/speed in which nothing else happens.
/// Beads that touch from the wall on are closed contacts. Others that touch are open ones with x = 0 and u = 0, and
/// close as soon as something pushes.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
template <class Watcher>
Outcome<Real> ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::run(Watcher& watcher) {
  Outcome<Real> outcome;
  this->regroup({0, N_ - 1}, Real(0));

  const std::uint64_t step_limit = 8 * stop_.event_limit();
  for (std::uint64_t step = 0;; ++step) {
    Real t = events_.time_of(events_.first());
    if constexpr (Watcher::observes) {
      watcher.until(epoch_ + t, [this](const Real& when, auto x, auto u) { state_at(when - epoch_, x, u); });
      if (watcher.done()) break;
    }
    if (t == std::numeric_limits<Real>::infinity()) {
      outcome.end = End::separated;
      break;
    }
    outcome.status = !(t >= 0) ? Status::non_finite : step >= step_limit ? Status::event_limit : why_stop();
    if (outcome.status != Status::ok) break;
    if (t > longest_clock && this->nothing_touches()) {
      this->begin_anew(t);
      t = Real(0);
    }
    this->advance(t);
    if (settled(step)) {
      outcome.end = End::settled;
      break;
    }
  }
  outcome.velocity = velocities(0);
  outcome.t_k = wall_opened_;
  outcome.x_max = x_max_;
  outcome.contacts = contacts_;
  return outcome;
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
Outcome<Real> ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::run() {
  NullObserver nobody;
  return run(nobody);
}

/// An open contact closes or a closed one opens, at overlap exactly 0. A disturbed column does so earlier or later by
/// -dx_k/u_k, and for so long feels, or lacks, the force C u_k: its rates jump by what that does.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::change_contact(std::size_t k, const Real& t) {
  for (int m = 1; m < motions; ++m) {
    auto& u = motion_[m].u;
    const Real handed_on = laws_.dashpot(k) * motion_[m].x[k];
    const Real impulse = closed_[k] ? Real(-handed_on) : handed_on;
    u[k] -= laws_.inertia(k) * impulse;
    if (k > 0) u[k - 1] += laws_.below(k) * impulse;
    if (k + 1 < N_) u[k + 1] += laws_.above(k) * impulse;
  }
  x_[k] = Real(0);
  closed_[k] = !closed_[k];
  if (closed_[k]) {
    ++closed_count_;
    return;
  }
  --closed_count_;
  ++contacts_;
  if (k == 0) wall_opened_ = epoch_ + t;
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::advance_free(std::size_t k, const Real& t) {
  const State now = this->free_state(k, t);
  x_[k] = now.x;
  u_[k] = now.u;
  for (int m = 1; m < motions; ++m) motion_[m].x[k] += motion_[m].u[k] * (t - at_[k]);
  using std::abs;
  const Real rounded = abs(u_[k]) * t + abs(x_[k]);  // on the clock, and what the overlap was the sum of
  for (int m = 1; m < motions; ++m)
    motion_[m].x[k] += Real(noise_.next()) * std::numeric_limits<Real>::epsilon() * rounded;
}

/// x and u of the group's contacts at `elapsed` after the start of its step.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::move_group(Group& group, const Real& elapsed,
                                                                              bool whole_step) {
  if constexpr (Ground::moves) {
    this->work_done_ += work_of(group, elapsed);
    if (group.resting) {
      x_max_ = std::max(x_max_, resting_.cluster().deepest(elapsed));
      return resting_.cluster().evaluate(elapsed, x_, u_);
    }
  }
  if (group.binary)
    move_binary(group, elapsed, whole_step);
  else
    move_taylor(group, elapsed, whole_step);
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::move_taylor(Group& group, const Real& elapsed,
                                                                               bool whole_step) {
  const std::size_t n = group.hi - group.lo + 1;
  const Real s = whole_step ? group.scaled : Real(elapsed / group.taylor.step());
  for (int m = 0; m < motions; ++m)
    group.taylor.evaluate(m, s, std::span(motion_[m].x).subspan(group.lo, n),
                          std::span(motion_[m].u).subspan(group.lo, n));
  if (Tangents > 0 && s > 0)
    for (std::size_t i = 0; i < n; ++i) disturb(group.lo + i, group.taylor.magnitude_of(i, s));
  for (std::size_t i = 0; i < n; ++i)
    if (closed_[group.lo + i]) x_max_ = group.taylor.deepest(i, s, x_max_);
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::move_binary(Group& group, const Real& elapsed,
                                                                               bool whole_step) {
  const std::size_t k = group.contact;
  const auto& contact = laws_.binary(k);
  const State entry = state(k);
  if (const Real deepest = contact.deepest(entry); deepest > x_max_) x_max_ = deepest;
  const auto map = whole_step ? contact.until_end(entry) : contact.after(elapsed);
  for (Motion& motion : motion_) {
    const State before{motion.x[k], motion.u[k]}, now = map(before);
    const State push = contact.push(before, now, elapsed);
    for (std::size_t gap = group.lo; gap <= group.hi; ++gap) {
      if (gap == k) continue;
      const Real between = gap < k ? laws_.below(k) : laws_.above(k);
      motion.x[gap] += motion.u[gap] * elapsed + between * push.x;
      motion.u[gap] += between * push.u;
    }
    motion.x[k] = now.x;
    motion.u[k] = now.u;
  }
  for (std::size_t i = group.lo; i <= group.hi; ++i) disturb(i, state(i));
}

/// A rounding error of the state of contact i, whose parts are of the given magnitude.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::disturb(std::size_t i, const State& magnitude) {
  if constexpr (Tangents > 0) {
    static_assert(Tangents <= 2);
    const Real rounding = local_error(), of_x = rounding * magnitude.x, of_u = rounding * magnitude.u;
    const auto random = noise_.four();
    for (int m = 1; m < motions; ++m) {
      motion_[m].x[i] += Real(random[std::size_t(2 * m - 2)]) * of_x;
      motion_[m].u[i] += Real(random[std::size_t(2 * m - 1)]) * of_u;
    }
  }
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::step_group(Group& group) {
  for (std::size_t k = group.lo; k <= group.hi; ++k) {
    // Rounding may leave a contact on the wrong side of 0.
    if (closed_[k] ? x_[k] < 0 : x_[k] > 0) x_[k] = Real(0);
  }
  if constexpr (Ground::moves) {
    group.resting = begin_rest(group);
    if (group.resting) return;
  }
  group.binary = begin_binary(group);
  if (!group.binary) begin_taylor(group);
}

/// A lone closed contact that nothing can disturb before it opens is followed to its end in one closed formula. As
/// x >= 0, each neighbouring gap stays below x_gap + u_gap t + push_bound(t), which is linear in t.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
bool ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::begin_binary(Group& group) {
  if (group.hi - group.lo > 2 || (Ground::moves && group.lo == 0)) return false;
  std::size_t k = group.lo;
  while (!closed_[k]) ++k;
  if (group.lo + 1 < k || k + 1 < group.hi) return false;
  const auto& contact = laws_.binary(k);
  const State entry = state(k);
  if (!contact.oscillates() || (entry.x == Real(0) && !(entry.u > 0))) return false;
  const Real duration = contact.time_left(entry);
  for (std::size_t gap = group.lo; gap <= group.hi; ++gap) {
    if (gap == k) continue;
    if (closed_[gap]) return false;
    const Real between = gap < k ? laws_.below(k) : laws_.above(k);
    const Real at_start = x_[gap] + between * contact.push_bound(entry, Real(0));
    const Real at_end = x_[gap] + u_[gap] * duration + between * contact.push_bound(entry, duration);
    if (at_start > 0 || !(at_end < 0)) return false;
  }
  group.length = duration;
  group.contact = k;
  group.event = true;
  return true;
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::begin_taylor(Group& group) {
  const std::size_t n = group.hi - group.lo + 1;
  auto& taylor = group.taylor;
  if (!group.prepared) {
    taylor.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = group.lo + i;
      if constexpr (HasUnequalMasses)
        taylor.set_law(i, closed_[k], column_.spring(k), laws_.dashpot(k), laws_.below(k), laws_.above(k));
      else
        taylor.set_law(i, closed_[k], column_.spring(k), laws_.dashpot(k), laws_.inertia(k));
    }
    group.longest = steps_.longest(group.lo, group.hi, closed_);
    group.prepared = true;
  }
  work_ += n;
  Real h = group.longest;
  if constexpr (Ground::moves) drive(group, h);
  for (int m = 0; m < motions; ++m)
    taylor.start(m, std::span(motion_[m].x).subspan(group.lo, n), std::span(motion_[m].u).subspan(group.lo, n), h);
  taylor.expand(h);
  const auto crossing = taylor.first_crossing();
  group.event = crossing.has_value();
  group.scaled = crossing ? crossing->when : Real(1);
  group.length = group.scaled * h;
  if (crossing) group.contact = group.lo + crossing->contact;
}

/// Looked at now and then: after some contacts, or after many steps in which overdamped contacts creep.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
bool ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::settled(std::uint64_t step) {
  if (!settle_schedule_.is_due(contacts_, step)) return false;
  const Balance now = balance();
  if (Tangents > 0 && (balances_.empty() || now.remaining < balances_.back().remaining)) balances_.push_back(now);
  return now.remaining < Real(stop_.settle());
}

/// Overlaps and rates of all contacts at a time between the last event and the next; changes nothing.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::state_at(const Real& t, std::span<Real> x,
                                                                            std::span<Real> u) const {
  for (std::size_t k = 0; k < N_; ++k) {
    if (group_of_[k] == Events::none) {
      const State now = this->free_state(k, t);
      x[k] = now.x;
      u[k] = now.u;
      continue;
    }
    const Group& group = Events::group(group_of_[k]);
    const Real elapsed = std::min(std::max(Real(t - group.start), Real(0)), group.length);
    const std::size_t n = group.hi - group.lo + 1, closed = group.contact;
    if constexpr (Ground::moves)
      if (group.resting) {
        resting_.cluster().evaluate(elapsed, x, u);
        k = group.hi;
        continue;
      }
    if (!group.binary) {
      group.taylor.evaluate(0, elapsed / group.taylor.step(), x.subspan(group.lo, n), u.subspan(group.lo, n));
      k = group.hi;
      continue;
    }
    const State entry = state(closed), now = laws_.binary(closed).after(elapsed)(entry);
    if (k == closed) {
      x[k] = now.x;
      u[k] = now.u;
    } else {
      const State push = laws_.binary(closed).push(entry, now, elapsed);
      const Real between = k < closed ? laws_.below(closed) : laws_.above(closed);
      x[k] = x_[k] + u_[k] * elapsed + between * push.x;
      u[k] = u_[k] + between * push.u;
    }
  }
}

/// A group that has the lowest bead is accelerated by the plate.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::drive(Group& group,
                                                                         Real& h) requires(Ground::moves) {
  if (group.lo > 0) return group.taylor.drive({}, h);
  h = std::min(h, taylor_reach / ground_.omega);
  group.taylor.drive(load_series<Order - 1>(ground_, group.start, h), h);
}

/// A group of closed contacts from the plate on, with an open one above them or none, as far as it lies still.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
bool ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::begin_rest(Group& group) requires(Ground::moves) {
  if (group.lo > 0 || !(ground_.load(group.start) > 0)) return false;
  std::size_t beads = 0;
  while (beads <= group.hi && closed_[beads]) ++beads;
  if (beads < group.hi || beads == 0 || beads > RestingBeads::max_beads(HasUnequalMasses)) return false;
  if (resting_.waits()) return false;
  const Real series_step = std::min(steps_.longest(group.lo, group.hi, closed_), taylor_reach / ground_.omega);
  const Real length = resting_.begin(column_, ground_, beads, x_, u_, group.start, series_step);
  if (!(length > 0)) return false;
  work_ += beads;
  group.length = length;
  group.event = false;
  return true;
}

/// int F_0 z0' dt and sum_k int C_k u_k^2 dt from the start of the group's step to `elapsed` later.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
PlateWork ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::work_of(const Group& group,
                                                                                const Real& elapsed) const
    requires(Ground::moves) {
  if (group.resting) return resting_.cluster().work(elapsed);
  PlateWork work;
  if (group.binary) {
    const std::size_t k = group.contact;
    const auto power = [&](double t) {
      const Real u = laws_.binary(k).after(t)(state(k)).u;
      return laws_.dashpot(k) * u * u;
    };
    work.lost = boost::math::quadrature::gauss<double, 20>::integrate(power, 0.0, elapsed);
    return work;
  }
  using Rule = boost::math::quadrature::gauss<double, 10>;  // a step's series has no more than 2 radians
  const std::size_t n = group.hi - group.lo + 1;
  std::vector<Real> x(n), u(n);
  const auto add = [&](double place, double weight) {
    const Real t = elapsed * 0.5 * (1.0 + place);
    group.taylor.evaluate(0, t / group.taylor.step(), x, u);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = group.lo + i;
      if (!closed_[k]) continue;
      work.lost += weight * laws_.dashpot(k) * u[i] * u[i];
      if (k == 0)
        work.in += weight * (column_.spring(0) * x[0] + laws_.dashpot(0) * u[0]) * ground_.speed(group.start + t);
    }
  };
  for (std::size_t j = 0; j < Rule::abscissa().size(); ++j)
    for (const double sign : {-1.0, 1.0}) add(sign * Rule::abscissa()[j], 0.5 * elapsed * Rule::weights()[j]);
  return work;
}

}  // namespace sigmasweep
