#include "solve/exact/lattice/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/first_root.hpp"

namespace sigmasweep {
namespace {

/// Beads that meet more slowly than `slowest_` do not touch before they overlap by so many closing overlaps: rounding
/// moves beads that lie side by side that fast, and a row of them without gaps would be at it for ever. It is next to
/// no energy: of the order of the accuracy. On a plate it would be pumped in again and again: there such contacts stay
/// closed instead (open_from()).
template <class Ground>
constexpr double shallow = Ground::moves ? 1.0 : 1e6;

}  // namespace

template <class Real, class Ground>
bool EventSchedule<Real, Ground>::is_valid(const LatticeEvent<Real>& e) const {
  if (e.kind == LatticeEventKind::step)
    return state_.clusters[e.other].in_use && state_.clusters[e.other].version == e.version;
  if (state_.beads[e.bead].version != e.version) return false;
  return e.kind == LatticeEventKind::list || e.other >= state_.beads.size() ||
         state_.beads[e.other].version == e.other_version;
}

template <class Real, class Ground>
Real EventSchedule<Real, Ground>::next_time() {
  while (!queue_.empty() && !is_valid(queue_.top())) queue_.pop();
  return queue_.empty() ? State::never : queue_.top().time;
}

template <class Real, class Ground>
void EventSchedule<Real, Ground>::enqueue(const Real& t, LatticeEventKind kind, std::uint32_t bead,
                                          const Neighbour<Real>& other) {
  if (!(t < State::never)) return;
  const std::uint32_t other_version = other.bead < state_.beads.size() ? state_.beads[other.bead].version : 0;
  queue_.push({t, kind, bead, other.bead, other.image, state_.beads[bead].version, other_version});
  // What is void lies in the queue until its time comes: not too much of it.
  constexpr std::size_t most = 64;
  if (queue_.size() > most * state_.beads.size() + 1000)
    queue_.keep_if([this](const LatticeEvent<Real>& e) { return is_valid(e); });
}

/// Two beads in uniform relative motion, or one and a wall: |r + w t| = d_ij, as c + 2 b t + w.w t^2 = 0 with
/// c = |r|^2 - d_ij^2 = gap (|r| + d_ij).
template <class Real, class Ground>
Real EventSchedule<Real, Ground>::meeting_in_flight(std::size_t i, const Neighbour<Real>& other, const Real& t) const {
  using std::sqrt;
  const BeadState<Real> me = state_.at(i, t);
  if (other.is_wall()) {
    const Real gap = other.bond.gap(me.q), rate = dot(other.bond.R, me.v);
    if constexpr (Ground::moves)
      if (other.bead == Neighbour<Real>::bottom)
        return t + state_.ground.landing({-(gap + closing_overlap_), -rate}, double(t));
    const Real overlap = rate < -slowest_ ? closing_overlap_ : Real(shallow<Ground>) * closing_overlap_;
    return rate < 0 ? t + std::max(Real(gap + overlap), Real(0)) / -rate : State::never;
  }
  const BeadState<Real> you = state_.at(other.bead, t);
  const Vec2<Real> q = me.q - you.q, r = other.bond.R + q, w = me.v - you.v;
  const Real b = dot(r, w);
  if (!(b < 0)) return State::never;
  const Real distance = sqrt(dot(r, r)), open = other.bond.gap(q);
  const auto meeting = [&](const Real& overlap, const Real& slowest) {
    const Real gap = std::max(Real(open + overlap), Real(0));
    const Real c = gap * (2 * distance - gap), discriminant = b * b - dot(w, w) * c;
    // At the meeting the square root is d_ij times the rate.
    return discriminant > slowest * slowest * distance * distance ? t + c / (sqrt(discriminant) - b) : State::never;
  };
  const Real soon = meeting(closing_overlap_, slowest_);
  return soon < State::never ? soon : meeting(Real(shallow<Ground>) * closing_overlap_, Real(0));
}

/// The same where a cluster moves one of them, from t to a time until which both motions are known.
template <class Real, class Ground>
Real EventSchedule<Real, Ground>::meeting_of_motions(std::size_t i, const Neighbour<Real>& other, const Real& t,
                                                     const Real& end) const {
  Motion<Real> from = state_.gap(i, other, t), to = state_.gap(i, other, end);
  // Below 0 by rounding: it counts where it goes from there.
  const Real shift = std::max(closing_overlap_, Real(-from.x)), span = end - t;
  from.x += shift;
  to.x += shift;
  if (Quintic<Real>::stays_positive(from, to, span)) return State::never;
  const Quintic<Real> gap(from, to, span);
  const auto when = FirstRoot<Real, 5>::find(gap.c, Real(1));
  if (!when || (gap.at(*when, span).u > -slowest_ && to.x - shift > -Real(shallow<Ground>) * closing_overlap_))
    return State::never;
  return t + *when * span;
}

/// The end of a contact, likewise.
template <class Real, class Ground>
Real EventSchedule<Real, Ground>::opening(std::size_t i, const Neighbour<Real>& other, const Real& t,
                                          const Real& end) const {
  const Motion<Real> first = state_.gap(i, other, t), last = state_.gap(i, other, end);
  const Real span = end - t;
  const auto reaches = [&](const Real& gap, Real& rate) {
    const Real shift = std::max(first.x, gap);
    const Motion<Real> from{shift - first.x, -first.u, -first.a}, to{shift - last.x, -last.u, -last.a};
    if (Quintic<Real>::stays_positive(from, to, span)) return State::never;
    const Quintic<Real> left(from, to, span);
    const auto when = FirstRoot<Real, 5>::find(left.c, Real(1));
    if (!when) return State::never;
    rate = -left.at(*when, span).u;
    return t + *when * span;
  };
  Real rate = 0;
  const Real opens = reaches(Real(0), rate);
  if (!(opens < State::never) || open_from(rate) == Real(0)) return opens;
  return reaches(open_from(rate), rate);
}

/// Whether they cannot meet before `end`, three times as fast as they ever are at the ends of their steps.
template <class Real, class Ground>
bool EventSchedule<Real, Ground>::is_far(std::size_t i, const Neighbour<Real>& other, const Real& t,
                                         const Real& end) const {
  using std::fabs;
  const auto speed = [](const Vec2<Real>& v) { return fabs(v.x) + fabs(v.z); };
  const BeadState<Real> now = state_.at(i, t), then = state_.at(i, end);
  Vec2<Real> q = now.q;
  Real fastest = std::max(speed(now.v), speed(then.v));
  if (!other.is_wall()) {
    const BeadState<Real> partner = state_.at(other.bead, t), finally = state_.at(other.bead, end);
    q -= partner.q;
    fastest += std::max(speed(partner.v), speed(finally.v));
  }
  return other.bond.gap(q) > 3 * fastest * (end - t);
}

template <class Real, class Ground>
void EventSchedule<Real, Ground>::predict_events(std::size_t i, const Neighbour<Real>& other, const Real& t) {
  const auto me = static_cast<std::uint32_t>(i);
  const bool alone = state_.beads[i].cluster < 0 && (other.is_wall() || state_.beads[other.bead].cluster < 0);
  if (alone) return enqueue(meeting_in_flight(i, other, t), LatticeEventKind::gap, me, other);
  const Real end = std::min(state_.until(i), other.is_wall() ? State::never : state_.until(other.bead));
  if (!(end > t)) return;
  const bool touching = state_.touches(i, other);
  if (!touching && is_far(i, other, t, end)) return;
  enqueue(touching ? opening(i, other, t, end) : meeting_of_motions(i, other, t, end), LatticeEventKind::gap, me,
          other);
}

/// All that may happen to bead i; what it may have with marked ones of smaller numbers is predicted from there.
template <class Real, class Ground>
void EventSchedule<Real, Ground>::predict_events(std::size_t i, const Real& t) {
  for (const Neighbour<Real>& other : state_.neighbours.of(i)) {
    const bool from_there = !other.is_wall() && other.bead < i && state_.is_marked(other.bead);
    if (!from_there) predict_events(i, other, t);
  }
}

/// When a free bead has gone its list's leeway; over a plate, not later than that.
template <class Real, class Ground>
Real EventSchedule<Real, Ground>::leaves(std::size_t i, const Real& t) const {
  using std::sqrt;
  const BeadState<Real> now = state_.at(i, t);
  const Vec2<Real> gone = now.q - state_.neighbours.anchor(i);
  const Real leeway = state_.neighbours.leeway();
  if constexpr (Ground::moves) {  // |gone| + |v| t + load t^2/2 <= leeway
    const Real left = std::max(Real(leeway - sqrt(dot(gone, gone))), Real(0)), speed = sqrt(dot(now.v, now.v));
    const Real load = state_.ground.g + state_.ground.A0 * state_.ground.omega * state_.ground.omega;
    return t + 2 * left / (speed + sqrt(speed * speed + 2 * load * left));
  }
  const Real a = dot(now.v, now.v), b = dot(gone, now.v),
             c = std::max(Real(leeway * leeway - dot(gone, gone)), Real(0));
  return a == Real(0) ? State::never : t + (sqrt(b * b + a * c) - b) / a;
}

template <class Real, class Ground>
LatticeEvent<Real> EventSchedule<Real, Ground>::take_next() {
  const LatticeEvent<Real> event = queue_.top();
  queue_.pop();
  return event;
}

template class EventSchedule<double, FixedWall>;
template class EventSchedule<long double, FixedWall>;
template class EventSchedule<double, Plate>;

}  // namespace sigmasweep
