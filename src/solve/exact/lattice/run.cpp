#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/exact/lattice/collision.hpp"
#include "solve/exact/lattice/events.hpp"
#include "solve/exact/lattice/vibrated.hpp"
#include "solve/fixed_step/lattice/vibrated.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/lattice_statistics.hpp"

/// From the first event to the last.
namespace sigmasweep {
namespace {

/// tc without an event after which contacts that stay closed are looked at.
constexpr double creeping = 50.0;

}  // namespace

template <class Real, class Ground>
Status LatticeEvents<Real, Ground>::why_stop() {
  if (step_underflow_) return Status::non_finite;
  const std::uint64_t work = std::exchange(work_, 1);
  all_work_ += work;
  return stop_.why_stop(contacts_, all_work_, work);
}

/// What pairs that approach, nothing touching, can lose: the sum of 1/2 m_red u^2.
template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::approach() {
  work_ += beads_.size();
  Real sum = 0;
  for (std::size_t i = 0; i < beads_.size(); ++i)
    for (const Neighbour<Real>& other : neighbours_.of(i)) {
      if (!other.is_wall() && other.bead < i) continue;
      const Real u = gap(i, other, now_).u;
      if (!(u < 0)) continue;
      const Real inertia = 1 / lattice_.mass(i) + (other.is_wall() ? Real(0) : Real(1 / lattice_.mass(other.bead)));
      sum += u * u / (2 * inertia);
    }
  return sum;
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::show_at(const Real& t, std::span<Vec2<double>> q, std::span<Vec2<double>> v) const {
  for (std::size_t i = 0; i < beads_.size(); ++i) {
    const BeadState<Real> state = at(i, t);
    q[i] = {double(state.q.x), double(state.q.z)};
    v[i] = {double(state.v.x), double(state.v.z)};
  }
}

template <class Real, class Ground>
template <class Watcher>
void LatticeEvents<Real, Ground>::show(Watcher& watcher, const Real& t) {
  watcher.until(double(epoch_ + t), [this](double when, auto q, auto v) { show_at(Real(when) - epoch_, q, v); });
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::handle_next() {
  const Event event = queue_.top();
  queue_.pop();
  now_ = std::max(now_, event.time);
  handle(event);
}

template <class Real, class Ground>
template <class Watcher>
LatticeOutcome<Real> LatticeEvents<Real, Ground>::run(Watcher& watcher) {
  constexpr double longest_clock = 64.0;
  const Column<Real>& beads = lattice_.beads;
  const Real quiet = lattice_.quiet_time(), budget = std::max(quiet, Real(creeping) * beads.tc);
  begin_anew(Real(0));
  LatticeOutcome<Real> outcome;
  while (outcome.end == End::none && (outcome.status = why_stop()) == Status::ok) {
    const Real t = next_event();
    if constexpr (Watcher::observes) {
      show(watcher, t);
      if (watcher.done()) break;
    } else if (closed_ == 0 && quiet > 0 && epoch_ + t > last_touch_ + quiet) {
      outcome.end = End::quiet;
      break;
    } else if (closed_ == 0 && quiet == Real(0) && contacts_ > 0) {
      const Real change = later_change(approach());
      if (change <= Real(stop_.settle())) {
        outcome.remainder = change;
        outcome.end = change == Real(0) ? End::separated : End::settled;
      }
    } else if (closed_ > 0 && epoch_ + now_ > last_change_ + budget) {
      const Real change = later_change(held() + (quiet > 0 ? Real(0) : approach()));
      if (change <= Real(stop_.settle())) {
        outcome.remainder = change;
        outcome.end = End::settled;
      }
      last_change_ = epoch_ + now_;
    }
    if (queue_.empty()) {
      outcome.end = End::separated;
    } else if (outcome.end == End::none) {
      if (t > longest_clock * beads.tc && closed_ == 0 && queue_.top().kind == Kind::gap) {
        begin_anew(t);
        continue;
      }
      handle_next();
    }
  }
  for (std::size_t i = 0; i < beads_.size(); ++i) outcome.velocity.push_back(at(i, now_).v);
  for (const auto& touching : touching_)
    for (const Neighbour<Real>& other : touching)
      if (other.bead == Neighbour<Real>::bottom) wall_opened_ = epoch_ + now_;  // it is still closed
  outcome.t_k = wall_closed_ < 0 ? Real(0) : wall_opened_ - wall_closed_;
  outcome.x_max = x_max_;
  outcome.contacts = contacts_;
  outcome.contact_time = contact_time_;
  if constexpr (!Watcher::observes)
    if (outcome.end == End::quiet) note_ending_uncertainty(outcome);
  return outcome;
}

/// What pairs that touch can lose: overdamped ones creep back for ever.
template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::held() {
  using std::pow;
  work_ += beads_.size();
  const Real power = Real(2.0 + lattice_.beads.exponents.beta), K = std::max(lattice_.beads.K, lattice_.beads.K_wall);
  Real sum = 0;
  for (std::size_t i = 0; i < beads_.size(); ++i)
    for (const Neighbour<Real>& other : touching_[i]) {
      const Motion<Real> now = gap(i, other, now_);
      sum += lattice_.mass(i) * now.u * now.u / 2 + K * Real(pow(std::max(Real(-now.x), Real(0)), power)) / power;
    }
  return sum;
}

template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::energy_at_start() const {
  Real mass = 0;
  for (std::size_t i = 0; i < beads_.size(); ++i) mass += lattice_.mass(i);
  return mass * lattice_.beads.speed * lattice_.beads.speed / 2;
}

/// What a loss of energy would change eps_eff = sqrt(E/E_0) by.
template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::later_change(const Real& loss) const {
  using std::sqrt;
  const Real E = kinetic(now_), left = std::max(Real(E - loss), Real(0));
  if (loss == Real(0) || E == Real(0)) return Real(0);
  return std::min(loss, E) / (sqrt(energy_at_start()) * (sqrt(E) + sqrt(left)));
}

/// What eps_eff would be if one of the waits had been the end; and, as the next contact is waited for half as long
/// again, if that had not been.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::note_ending_uncertainty(LatticeOutcome<Real>& outcome) {
  using std::fabs, std::sqrt;
  const Real latest = last_touch_ + Real(1.5) * lattice_.quiet_time(), E = kinetic(now_);
  outcome.waits = waits_;
  for (auto& wait : outcome.waits.longest)
    if (wait.length > 0) wait.change = fabs(Real(sqrt(wait.change) - sqrt(E))) / sqrt(energy_at_start());
  const Real next_change = later_change(approach());
  while (closed_ == 0 && why_stop() == Status::ok && epoch_ + next_event() < latest) handle_next();
  outcome.waits.note({(closed_ > 0 ? epoch_ + now_ : latest) - last_touch_, next_change});
}

/// As energy_on_plate() of a column; of gravity 0 for beads on their sites.
template <class Real, class Ground>
double LatticeEvents<Real, Ground>::energy(const Real& t) const requires(Ground::moves) {
  const double power = 2.0 + lattice_.beads.exponents.beta, speed = ground_.speed(double(t));
  double sum = 0.0;
  for (std::size_t i = 0; i < beads_.size(); ++i) {
    const BeadState<Real> state = at(i, t);
    const double x = double(state.v.x), z = double(state.v.z) + speed;
    sum += double(lattice_.mass(i)) *
           (0.5 * (x * x + z * z) + ground_.g * (double(state.q.z) + ground_.height(double(t))));
    for (const Neighbour<Real>& other : touching_[i])
      if (const double overlap = -double(gap(i, other, t).x); overlap > 0.0 && (other.is_wall() || i < other.bead))
        sum += double(other.is_wall() ? lattice_.beads.K_wall : lattice_.beads.K) * std::pow(overlap, power) / power;
  }
  return sum;
}

template <class Real, class Ground>
template <class Watcher>
LatticeOutcome<Real> LatticeEvents<Real, Ground>::follow(Watcher& watcher) requires(Ground::moves) {
  const Real period = ground_.period();
  const auto show_until = [&](const Real& t) {
    watcher.until(double(t), [this](double when, auto q, auto v) { show_at(Real(when), q, v); });
  };
  begin_anew(Real(0));
  const double at_start = energy(Real(0));
  LatticeOutcome<Real> outcome;
  while (!watcher.done() && (outcome.status = why_stop()) == Status::ok) {
    if (const Real t = next_event(); t < period) {
      show_until(t);
      handle_next();
      continue;
    }
    show_until(period);
    count_contact_time(period);
    begin_anew(period);
    epoch_ = counted_to_ = Real(0);
    watcher.end_period(energy(Real(0)) - at_start, work_done_.in, work_done_.lost);
  }
  if (outcome.status == Status::ok) outcome.end = End::periods;
  outcome.x_max = x_max_;
  outcome.contacts = contacts_;
  outcome.contact_time = contact_time_;
  return outcome;
}

template <class Real>
LatticeOutcome<Real> lattice_collision(const Lattice<Real>& lattice, double accuracy, const RunLimits& limits) {
  NullObserver nobody;
  return LatticeEvents<Real>(lattice, accuracy, limits).run(nobody);
}
template LatticeOutcome<double> lattice_collision(const Lattice<double>&, double, const RunLimits&);
template LatticeOutcome<long double> lattice_collision(const Lattice<long double>&, double, const RunLimits&);

void observe_lattice(const Lattice<double>& lattice, LatticeSamples& samples) {
  LatticeEvents<double>(lattice, 1e-12, {}).run(samples);
}

template <class Watcher>
LatticeOutcome<double> follow_lattice(const Lattice<double>& lattice, const Plate& plate, double accuracy,
                                      const RunLimits& limits, Watcher& watcher) {
  return LatticeEvents<double, Plate>(lattice, accuracy, limits, plate).follow(watcher);
}
template LatticeOutcome<double> follow_lattice(const Lattice<double>&, const Plate&, double, const RunLimits&,
                                               LatticeStatistics&);
template LatticeOutcome<double> follow_lattice(const Lattice<double>&, const Plate&, double, const RunLimits&,
                                               VibratedLatticeSamples&);

}  // namespace sigmasweep
