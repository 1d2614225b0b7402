#include "solve/exact/power_law/group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/first_root.hpp"
#include "numerics/hermite.hpp"

namespace sigmasweep {
namespace {

/// A contact that reaches x = 0 (or left it) within this time, in tc, if it goes on as it does, is led by its s.
constexpr double near = 0.15;

/// Spans tried for a step before it is given up, and those in a leader's variable before the time takes over.
constexpr int max_tries = 400, budget = 12;

}  // namespace

template <class Real, class Ground>
PowerLawGroup<Real, Ground>::PowerLawGroup(const Column<Real>& column, const Real& accuracy, const Ground& ground)
    : column_(column),
      ground_(ground),
      force_(column.exponents),
      accuracy_(accuracy),
      delta_(closing_overlap(accuracy)),
      q_(clock_exponent(column.exponents)),
      next_time_span_(Real(0.02)) {}

template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::start(std::size_t lo, std::size_t hi, std::span<const std::uint8_t> closed,
                                        std::span<const Real> x, std::span<const Real> u) {
  lo_ = lo;
  n_ = hi - lo + 1;
  closed_.assign(closed.begin() + std::ptrdiff_t(lo), closed.begin() + std::ptrdiff_t(hi) + 1);
  for (auto* v : {&K_, &C_, &below_, &above_, &inertia_}) v->resize(n_);
  F_.assign(n_ + 2, Real(0));
  for (auto* v : {&start_, &end_, &start_slope_, &end_slope_}) v->resize(2 * n_ + (Ground::moves ? 2 : 0));
  at_start_.resize(n_);
  scratch_.resize(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    const std::size_t k = lo + i;
    K_[i] = closed_[i] ? column_.spring(k) : Real(0);
    C_[i] = closed_[i] ? column_.dashpot(k) : Real(0);
    below_[i] = k == 0 ? Real(0) : column_.inverse_mass(k - 1);
    above_[i] = column_.inverse_mass(k);
    inertia_[i] = below_[i] + above_[i];
    at_start_[i] = x[k];
    end_[n_ + i] = u[k];
  }
  leader_ = none;
  next_time_span_ = std::max(next_time_span_, Real(1e-3));
}

template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::power_of(const Real& s, int n) const {
  Real product = 1;
  for (int i = 0; i < n; ++i) product *= s;
  return product;
}

template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::slopes(const State& y, State& dy, const Real& at) {
  const Real* x = y.data();
  const Real* u = y.data() + n_;
  if (leader_ != none) {
    std::copy_n(x, n_, scratch_.begin());
    scratch_[leader_] = power_of(at, q_);
    x = scratch_.data();
  }
  Real* F = F_.data() + 1;
  force_(n_, K_.data(), C_.data(), x, u, F);
  Real* dx = dy.data();
  Real* du = dy.data() + n_;
#pragma GCC ivdep
  for (std::size_t i = 0; i < n_; ++i) {
    dx[i] = u[i];
    du[i] = below_[i] * F[std::ptrdiff_t(i) - 1] - inertia_[i] * F[i] + above_[i] * F[i + 1];
  }
  if constexpr (Ground::moves) drive(dy, x, u, leader_ == none ? at : y[leader_]);
  if (leader_ == none) return;
  const Real dt = Real(q_) * power_of(at, q_ - 1) / u[leader_];
  for (Real& slope : dy) slope *= dt;
  dx[leader_] = dt;
}

/// One step of the scheme over `span`; its estimated error over the accuracy.
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::trial(const Real& span) {
  span_ = span;
  work_ += n_;
  const auto system = [this](const State& y, State& dy, const Real& at) { slopes(y, dy, at); };
  return error_ = scheme_.step(system, start_, start_slope_, from_, span, end_) / accuracy_;
}

/// Of the closed contacts near x = 0 the fastest: its kink is the strongest.
template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::choose_leader() {
  using std::fabs;
  std::size_t fastest = none;
  for (std::size_t i = 0; i < n_ && q_ > 1; ++i) {
    const Real u = fabs(start_[n_ + i]);
    if (!closed_[i] || i == banned_ || !(at_start_[i] > 0) || !(at_start_[i] < Real(near) * u)) continue;
    if (fastest == none || u > fabs(start_[n_ + fastest])) fastest = i;
  }
  lead_by(fastest);
}

/// Puts the state of the step's start (at_start_, rates in start_) into the leader's variables.
template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::lead_by(std::size_t contact) {
  using std::pow;
  const bool same = leader_ == contact;
  leader_ = contact;
  std::copy_n(at_start_.begin(), n_, start_.begin());
  from_ = Real(0);
  if (contact != none) {
    from_ = q_ == 1 ? at_start_[contact] : Real(pow(at_start_[contact], Real(1) / Real(q_)));
    start_[contact] = Real(0);
    if (!same) next_s_span_ = Real(0);
  }
  slopes(start_, start_slope_, from_);
}

/// Of the step's length, in the leader's s or in time.
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::first_guess() const {
  using std::fabs, std::pow;
  if (leader_ == none) return next_time_span_;
  const Real u = start_[n_ + leader_];
  const Real size =
      next_s_span_ != Real(0) ? Real(fabs(next_s_span_)) : Real(0.3) * pow(Real(near) * fabs(u), Real(1) / Real(q_));
  return u > 0 ? size : size > Real(0.7) * from_ ? Real(-from_) : Real(-size);
}

template <class Real, class Ground>
bool PowerLawGroup<Real, Ground>::leader_reverses() const {
  return !(start_[n_ + leader_] * end_[n_ + leader_] > 0);
}

/// The span to try after one with this error, by the scheme's order.
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::shortened(const Real& span, const Real& error) const {
  using std::pow;
  if (error <= 1) return span / 4;  // not the error: the leader turned round within the step
  if (!(error < Real(1e10))) return span / 5;
  return span * std::max(Real(0.2), std::min(Real(0.5), Real(0.9) * pow(error, Real(-0.125))));
}
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::lengthened(const Real& span, const Real& error) const {
  using std::pow;
  return span * std::min(Real(4), Real(0.9) * pow(std::max(error, Real(1e-8)), Real(-0.125)));
}

template <class Real, class Ground>
bool PowerLawGroup<Real, Ground>::step(const Real& begin) {
  begin_ = begin;
  if constexpr (Ground::moves) start_[2 * n_] = start_[2 * n_ + 1] = Real(0);
  std::copy_n(end_.begin() + std::ptrdiff_t(n_), n_, start_.begin() + std::ptrdiff_t(n_));
  banned_ = none;
  choose_leader();
  Real span = first_guess();
  for (int tries = 0; tries < max_tries; ++tries) {
    const Real error = trial(span);
    if (!(error <= 1) || (leader_ != none && leader_reverses())) {
      span = shortened(span, error);
      if (leader_ != none && tries > budget) {  // it turns round before x = 0
        banned_ = leader_;
        lead_by(none);
        span = first_guess();
      }
      continue;
    }
    slopes(end_, end_slope_, from_ + span_);
    const auto crossing = first_crossing(none);
    if (crossing && should_lead(crossing->contact)) {
      if (start_[n_ + crossing->contact] < 0) {  // its own variable ends at x = 0
        lead_by(crossing->contact);
        span = -from_;
      } else {
        span *= crossing->fraction / 2;
      }
      continue;
    }
    if (!crossing) (leader_ == none ? next_time_span_ : next_s_span_) = lengthened(span_, error);
    end_at(crossing);
    if (crossing && !(error_ <= 1)) {  // it ends at a kink, which the whole step did not see
      span = span_ / 2;
      continue;
    }
    return true;
  }
  return false;
}

/// Whether a contact that opens within a step in time is better followed in its own variable.
template <class Real, class Ground>
bool PowerLawGroup<Real, Ground>::should_lead(std::size_t i) const {
  return leader_ == none && closed_[i] && i != banned_ && at_start_[i] > 0;
}

/// Ends the step at the first of its events.
template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::end_at(std::optional<Crossing> crossing) {
  event_.reset();
  while (crossing) {
    event_.reset();
    if (locate(crossing->contact, crossing->fraction)) event_ = crossing->contact;
    crossing = first_crossing(crossing->contact);
  }
  if (leader_ != none && from_ + span_ == Real(0)) event_ = leader_;
  length_ = leader_ == none ? span_ : end_[leader_];
  if (event_) *event_ += lo_;
}

template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::read(const State& y, const Real& at, std::span<Real> x, std::span<Real> u) {
  for (std::size_t i = 0; i < n_; ++i) {
    x[lo_ + i] = i == leader_ ? power_of(at, q_) : y[i];
    u[lo_ + i] = y[n_ + i];
  }
  if constexpr (Ground::moves) done_ = {y[2 * n_], y[2 * n_ + 1]};
}

template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::finish(std::span<Real> x, std::span<Real> u) {
  read(end_, from_ + span_, x, u);
  if (event_) x[*event_] = closed_[*event_ - lo_] ? Real(0) : delta_;
  for (std::size_t i = 0; i < n_; ++i) {
    // Rounding may leave a contact on the wrong side of 0.
    if (closed_[i] && x[lo_ + i] < 0) x[lo_ + i] = Real(0);
    at_start_[i] = x[lo_ + i];
  }
}

/// The span after which the time is `elapsed`; in s by Newton's method with one step of the scheme each.
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::span_for(const Real& elapsed) {
  using std::fabs;
  if (leader_ == none) return elapsed;
  const Real whole = span_;
  Real span = whole / 2, low = 0, high = 1;  // fractions of the whole
  for (int i = 0; i < 60; ++i) {
    trial(span);
    slopes(end_, end_slope_, from_ + span_);
    const Real late = end_[leader_] - elapsed;
    (late > 0 ? high : low) = span / whole;
    if (fabs(late) <= 4 * std::numeric_limits<Real>::epsilon() * length_) break;
    const Real next = (span - late / end_slope_[leader_]) / whole;
    const Real then = next > low && next < high ? next : Real((low + high) / 2);
    if (then * whole == span) break;
    span = then * whole;
  }
  return span;
}

template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::within(const Real& elapsed, std::span<Real> x, std::span<Real> u) {
  if (elapsed >= length_) return read(end_, from_ + span_, x, u);
  const State end = end_, end_slope = end_slope_;
  const Real whole = span_;
  trial(span_for(elapsed));
  read(end_, from_ + span_, x, u);
  end_ = end;
  end_slope_ = end_slope;
  span_ = whole;
}

/// d^2 x_i/d(independent variable)^2.
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::second_slope(const State& y, const State& dy, const Real& at, std::size_t i) const {
  if (leader_ == none) return dy[n_ + i];
  const Real u = y[n_ + leader_], dt = dy[leader_];
  const Real curl = q_ == 1 ? Real(0) : Real(Real(q_ * (q_ - 1)) * power_of(at, q_ - 2) / u);
  return dy[n_ + i] * dt + y[n_ + i] * (curl - dt * dy[n_ + leader_] / u);
}

/// The overlap in the fraction of the step.
template <class Real, class Ground>
std::array<Real, 6> PowerLawGroup<Real, Ground>::hermite(std::size_t i) const {
  const Motion<Real> from{start_[i], start_slope_[i], second_slope(start_, start_slope_, from_, i)};
  const Motion<Real> to{end_[i], end_slope_[i], second_slope(end_, end_slope_, from_ + span_, i)};
  return Quintic<Real>(from, to, span_).c;
}

/// The first contact, but for one, that changes its state within the step, by the steps' own polynomials: with what the
/// step control leaves of an error there a contact that is overlooked is too shallow to matter.
template <class Real, class Ground>
auto PowerLawGroup<Real, Ground>::first_crossing(std::size_t but) const -> std::optional<Crossing> {
  std::optional<Crossing> first;
  for (std::size_t i = 0; i < n_; ++i) {
    if (i == but || i == leader_) continue;
    std::array<Real, 6> distance = hermite(i);
    const Real goal = target(i), sign = closed_[i] ? Real(1) : Real(-1);
    distance[0] -= goal;
    for (Real& c : distance) c *= sign;
    if (distance[0] < 0) distance[0] = 0;
    const bool leaves_rightly = distance[0] == Real(0) && !(distance[1] < 0) && sign * (end_[i] - goal) >= 0;
    if (leaves_rightly) continue;
    const auto when = FirstRoot<Real, 5>::find(distance, first ? first->fraction : Real(1));
    if (when) first = Crossing{i, *when};
  }
  return first;
}

/// Shortens the step so that contact i reaches its event at the end: Newton's method, one step of the scheme each, kept
/// within a bracket. False if it does not get there; the step is left shortened to where it comes closest.
template <class Real, class Ground>
bool PowerLawGroup<Real, Ground>::locate(std::size_t i, const Real& fraction) {
  using std::fabs;
  const Real whole = span_, sign = closed_[i] ? Real(1) : Real(-1), goal = target(i);
  bool bracketed = sign * (end_[i] - goal) < 0;
  Real low = 0, high = 1, at = std::max(fraction, std::numeric_limits<Real>::min());
  for (int iteration = 0; iteration < 60; ++iteration) {
    trial(at * whole);
    slopes(end_, end_slope_, from_ + span_);
    const Real distance = sign * (end_[i] - goal), slope = sign * end_slope_[i] * whole;
    if (distance > 0)
      low = at;
    else
      bracketed = true, high = at;
    if (fabs(distance) <= delta_ * Real(0.1) && slope < 0) return true;
    Real next = at - distance / slope;
    if (!(next > low && next < high)) {
      if (!bracketed && iteration > 4) return false;
      next = (low + high) / 2;
    }
    if (next == at || next == low || next == high) return slope <= 0;
    at = next;
  }
  return bracketed;
}

/// Overlap of contact i where its rate goes through zero within the step: Newton's method, one step of the scheme each.
template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::maximum(std::size_t i) {
  const State end = end_, end_slope = end_slope_;
  const Real whole = span_;
  const Real before = start_[n_ + i], after = end_[n_ + i];
  Real at = whole * (before / (before - after));
  for (int iteration = 0; iteration < 4; ++iteration) {
    trial(at);
    slopes(end_, end_slope_, from_ + span_);
    const Real next = at - end_[n_ + i] / end_slope_[n_ + i];
    if (!(next / whole > 0 && next / whole < 1)) break;
    at = next;
  }
  const Real largest = end_[i];
  end_ = end;
  end_slope_ = end_slope;
  span_ = whole;
  return largest;
}

template <class Real, class Ground>
Real PowerLawGroup<Real, Ground>::deepest(const Real& known) {
  using std::fabs;
  Real largest = known;
  for (std::size_t i = 0; i < n_; ++i) {
    if (!closed_[i]) continue;
    if (i == leader_) {
      largest = std::max({largest, power_of(from_, q_), power_of(from_ + span_, q_)});
      continue;
    }
    largest = std::max({largest, start_[i], end_[i]});
    const Real turn = start_[n_ + i], turned = end_[n_ + i];
    const bool may_exceed = std::max(start_[i], end_[i]) + std::min(turn, Real(-turned)) * length_ / 2 > largest;
    if (turn > 0 && turned < 0 && may_exceed) largest = std::max(largest, maximum(i));
  }
  return largest;
}

template class PowerLawGroup<double>;
template class PowerLawGroup<long double>;
template class PowerLawGroup<double, Plate>;

}  // namespace sigmasweep
