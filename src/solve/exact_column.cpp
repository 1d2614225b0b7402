#include "exact_column.hpp"

#include "sigmasweep/scene/real.hpp"

namespace sigmasweep {

template <class Real>
ExactColumn<Real>::ExactColumn(const Column<Real>& column, const ExactOptions& options)
    : column_(column),
      options_(options),
      N_(std::size_t(column.N)),
      wall_(column.K_wall, column.C_wall, inertia(0)),
      pair_(column.K, column.C, inertia(1)),
      steps_(column),
      x_(N_, -column.gap),
      u_(N_, Real(0)),
      at_(N_, Real(0)),
      closed_(N_, 0),
      group_of_(N_, none),
      events_(N_) {
  if (options_.event_limit == 0) options_.event_limit = 100'000 + 50 * N_ * N_;
  u_[0] = column.speed;
}

/// The clock starts at the first contact with the wall, after a flight of gap/speed in which nothing else happens.
template <class Real>
Outcome<Real> ExactColumn<Real>::run() {
  Outcome<Real> outcome;
  if (column_.gap == Real(0)) {
    closed_.assign(N_, 1);
    closed_count_ = N_;
  } else {
    x_[0] = Real(0);
    closed_[0] = 1;
    closed_count_ = 1;
  }
  regroup(0, N_ - 1, Real(0));

  const std::uint64_t step_limit = 8 * options_.event_limit;
  for (std::uint64_t step = 0;; ++step) {
    const std::size_t next = events_.first();
    const Real t = events_.time_of(next);
    if (t == std::numeric_limits<Real>::infinity()) {
      outcome.end = End::separated;
      break;
    }
    if (contacts_ >= options_.event_limit || step >= step_limit || !(t >= 0)) {
      outcome.status = t >= 0 ? Status::event_limit : Status::non_finite;
      break;
    }
    if (group_of_[next] != none)
      finish_step(group_of_[next]);
    else
      close_gap(next, t);
    if (closed_count_ == 0 && settled()) {
      outcome.end = End::settled;
      break;
    }
  }
  outcome.velocity = velocities();
  outcome.t_k = wall_opened_;
  outcome.x_max = x_max_;
  outcome.contacts = contacts_;
  return outcome;
}

template <class Real>
void ExactColumn<Real>::close_gap(std::size_t k, const Real& t) {
  synchronise(k, t);
  change_contact(k, t);
  regroup(k, k, t);
}

template <class Real>
void ExactColumn<Real>::finish_step(int id) {
  Group& group = *groups_[std::size_t(id)];
  const Real t = group.start + group.length;
  move_group(group, group.length, true);
  group.start = t;
  if (!group.event) {
    begin_step(id);
    return;
  }
  change_contact(group.contact, t);
  const std::size_t lo = group.lo, hi = group.hi;
  dissolve(id, t);
  regroup(lo, hi, t);
}

/// An open contact closes or a closed one opens, at overlap exactly 0.
template <class Real>
void ExactColumn<Real>::change_contact(std::size_t k, const Real& t) {
  x_[k] = Real(0);
  closed_[k] = !closed_[k];
  if (closed_[k]) {
    ++closed_count_;
    return;
  }
  --closed_count_;
  ++contacts_;
  if (k == 0) wall_opened_ = t;
}

/// Brings a gap between two free beads up to time t.
template <class Real>
void ExactColumn<Real>::synchronise(std::size_t k, const Real& t) {
  x_[k] += u_[k] * (t - at_[k]);
  at_[k] = t;
}

/// x and u of the group's contacts at `elapsed` after the start of its step.
template <class Real>
void ExactColumn<Real>::move_group(Group& group, const Real& elapsed, bool whole_step) {
  if (!group.binary) {
    const std::size_t n = group.hi - group.lo + 1;
    const Real s = whole_step ? group.scaled : Real(elapsed / group.taylor.step());
    const auto x = std::span(x_).subspan(group.lo, n), u = std::span(u_).subspan(group.lo, n);
    group.taylor.evaluate(s, x, u);
    // An overlap that grew at first and shrinks now was largest in between; as x is concave there it lies below both
    // tangents.
    for (std::size_t i = 0; i < n; ++i) {
      const State before = group.taylor.start(i);
      if (!closed_[group.lo + i] || !(before.u > 0) || !(u[i] < 0)) continue;
      if (std::min(before.x + before.u * elapsed, x[i] - u[i] * elapsed) > x_max_)
        x_max_ = std::max(x_max_, group.taylor.deepest(i, s));
    }
    return;
  }
  const std::size_t k = group.contact;
  const auto& contact = binary(k);
  const State now = whole_step ? contact.end(group.entry) : contact.at(group.entry, elapsed);
  const State push = contact.push(group.entry, now, elapsed);
  for (std::size_t gap = group.lo; gap <= group.hi; ++gap) {
    if (gap == k) continue;
    x_[gap] += u_[gap] * elapsed + push.x;
    u_[gap] += push.u;
  }
  if (const Real deepest = contact.deepest(group.entry); deepest > x_max_) x_max_ = deepest;
  x_[k] = now.x;
  u_[k] = now.u;
}

/// Ends a group; if its step is not over yet, at a time t within it.
template <class Real>
void ExactColumn<Real>::dissolve(int id, const Real& t) {
  Group& group = *groups_[std::size_t(id)];
  if (group.start != t) move_group(group, std::min(std::max(Real(t - group.start), Real(0)), group.length), false);
  for (std::size_t k = group.lo; k <= group.hi; ++k) {
    group_of_[k] = none;
    at_[k] = t;
  }
  events_.remove(group.lo);
  idle_.push_back(id);
}

/// Sorts contacts lo..hi, all of them free of groups and at time t, into groups and free gaps, taking in neighbours
/// that a closed contact at the border touches.
template <class Real>
void ExactColumn<Real>::regroup(std::size_t lo, std::size_t hi, const Real& t) {
  const auto take = [&](std::size_t k) {  // returns what to extend the range by
    const int id = group_of_[k];
    if (id == none) {
      synchronise(k, t);
      return std::pair(k, k);
    }
    const std::pair range(groups_[std::size_t(id)]->lo, groups_[std::size_t(id)]->hi);
    dissolve(id, t);
    return range;
  };
  while (closed_[lo] && lo > 0) lo = take(lo - 1).first;
  while (closed_[hi] && hi + 1 < N_) hi = take(hi + 1).second;

  std::size_t k = lo;
  while (k <= hi) {
    if (!closed_[k] && !(k < hi && closed_[k + 1])) {
      schedule_gap(k);
      ++k;
      continue;
    }
    std::size_t end = k;  // the group's last contact: an open one with no closed one after it, or the border
    while (end < hi && (closed_[end] || closed_[end + 1])) ++end;
    make_group(k, end, t);
    k = end + 1;
  }
}

template <class Real>
void ExactColumn<Real>::make_group(std::size_t lo, std::size_t hi, const Real& t) {
  if (idle_.empty()) {
    idle_.push_back(int(groups_.size()));
    groups_.push_back(std::make_unique<Group>());
  }
  const int id = idle_.back();
  idle_.pop_back();
  Group& group = *groups_[std::size_t(id)];
  group.lo = lo;
  group.hi = hi;
  group.start = t;
  group.prepared = false;
  for (std::size_t k = lo; k <= hi; ++k) {
    group_of_[k] = id;
    if (k != lo) events_.remove(k);
  }
  begin_step(id);
}

template <class Real>
void ExactColumn<Real>::begin_step(int id) {
  Group& group = *groups_[std::size_t(id)];
  for (std::size_t k = group.lo; k <= group.hi; ++k) {
    if (options_.perturbation > 0) {
      x_[k] = disturbed(x_[k]);
      u_[k] = disturbed(u_[k]);
    }
    // Rounding may leave a contact on the wrong side of 0.
    if (closed_[k] ? x_[k] < 0 : x_[k] > 0) x_[k] = Real(0);
  }
  group.binary = begin_binary(group);
  if (!group.binary) begin_taylor(group);
  events_.set(group.lo, group.start + group.length);
}

/// A lone closed contact that nothing can disturb before it opens is followed to its end in one closed formula. As
/// x >= 0, each neighbouring gap stays below x_gap + u_gap t + push_bound(t), which is linear in t.
template <class Real>
bool ExactColumn<Real>::begin_binary(Group& group) {
  if (group.hi - group.lo > 2) return false;
  std::size_t k = group.lo;
  while (!closed_[k]) ++k;
  if (group.lo + 1 < k || k + 1 < group.hi) return false;
  const auto& contact = binary(k);
  const State entry{x_[k], u_[k]};
  if (!contact.oscillates() || (entry.x == Real(0) && !(entry.u > 0))) return false;
  const Real duration = contact.time_left(entry);
  for (std::size_t gap = group.lo; gap <= group.hi; ++gap) {
    if (gap == k) continue;
    if (closed_[gap]) return false;
    const Real at_start = x_[gap] + contact.push_bound(entry, Real(0));
    const Real at_end = x_[gap] + u_[gap] * duration + contact.push_bound(entry, duration);
    if (at_start > 0 || !(at_end < 0)) return false;
  }
  group.entry = entry;
  group.length = duration;
  group.contact = k;
  group.event = true;
  return true;
}

template <class Real>
void ExactColumn<Real>::begin_taylor(Group& group) {
  const std::size_t n = group.hi - group.lo + 1;
  auto& taylor = group.taylor;
  if (!group.prepared) {
    taylor.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = group.lo + i;
      taylor.set_law(i, closed_[k], K(k), C(k), inertia(k));
    }
    group.longest = longest_step(group);
    group.prepared = true;
  }
  const Real h = group.longest;
  taylor.expand(std::span(x_).subspan(group.lo, n), std::span(u_).subspan(group.lo, n), h);
  const auto crossing = taylor.first_crossing();
  group.event = crossing.has_value();
  group.scaled = crossing ? crossing->when : Real(1);
  group.length = group.scaled * h;
  if (crossing) group.contact = group.lo + crossing->contact;
}

/// The shortest of what the group's chains of closed contacts allow.
template <class Real>
Real ExactColumn<Real>::longest_step(const Group& group) const {
  Real h = steps_.unconnected();
  for (std::size_t k = group.lo; k <= group.hi; ++k) {
    const std::size_t first = k;
    while (k <= group.hi && closed_[k]) ++k;
    if (k > first) h = std::min(h, first == 0 ? steps_.at_wall(k - first) : steps_.free(k - first));
  }
  return h;
}

template <class Real>
void ExactColumn<Real>::schedule_gap(std::size_t k) {
  if (u_[k] > 0)
    events_.set(k, at_[k] + std::max(Real(-x_[k]), Real(0)) / u_[k]);
  else
    events_.remove(k);
}

/// value (1 + perturbation r), r uniform in +-1 roundings; splitmix64, so that every run draws the same numbers.
template <class Real>
Real ExactColumn<Real>::disturbed(const Real& value) {
  std::uint64_t z = (noise_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  const double r = double(std::int64_t(z ^ (z >> 31))) * 0x1p-63;
  return value * (1 + Real(options_.perturbation * r) * std::numeric_limits<Real>::epsilon());
}

template <class Real>
bool ExactColumn<Real>::settled() {
  if (options_.settle <= 0 || contacts_ < checked_at_ + (N_ + 1) / 2) return false;
  checked_at_ = contacts_;
  const std::vector<Real> v = velocities();
  return residual_dissipation<Real>(v, column_.speed) < Real(options_.settle);
}

/// v_i from the rates: u_0 = -v_1 at the wall, u_k = v_{k-1} - v_k between beads.
template <class Real>
std::vector<Real> ExactColumn<Real>::velocities() const {
  std::vector<Real> v(N_);
  Real sum = 0;
  for (std::size_t k = 0; k < N_; ++k) v[k] = sum -= u_[k];
  return v;
}

template class ExactColumn<double>;
template class ExactColumn<long double>;
template class ExactColumn<Quad>;

template <class Real>
Outcome<Real> exact_collision(const Column<Real>& column, const ExactOptions& options) {
  return ExactColumn<Real>(column, options).run();
}
template Outcome<double> exact_collision(const Column<double>&, const ExactOptions&);
template Outcome<long double> exact_collision(const Column<long double>&, const ExactOptions&);
template Outcome<Quad> exact_collision(const Column<Quad>&, const ExactOptions&);

}  // namespace sigmasweep
