#include "solve/exact/lattice/events.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/lattice_statistics.hpp"

namespace sigmasweep {
namespace {

/// smallest_overlap() where nothing flies far.
template <class Real>
Real least_overlap(const Lattice<Real>& lattice, double accuracy) {
  const Real unit = lattice.beads.speed * lattice.beads.tc;
  return std::max(Real(0.01 * accuracy), 4096 * std::numeric_limits<Real>::epsilon()) * unit;
}
/// The overlap at which a gap counts as closed: the force that is left out is below the accuracy. Not less than what
/// rounding makes of positions, so that beads that lie side by side do not open and close for ever.
template <class Real>
Real smallest_overlap(const Lattice<Real>& lattice, double accuracy) {
  return least_overlap(lattice, accuracy) + lattice.rounding() * lattice.beads.speed * lattice.beads.tc;
}

/// Speed below which beads meet too slowly to count (schedule.cpp), in least overlaps a tc.
constexpr double slow = 1000.0;

/// Time between sync times: short enough for the interpolation of motions, whose velocities are off by up to
/// 1.6e-4 omega (omega h)^5 of an amplitude, at the fastest mode omega. See docs/physics/lattices.md.
template <class Real>
Real longest_step(const Lattice<Real>& lattice, double accuracy) {
  using std::sqrt;
  const Column<Real>& beads = lattice.beads;
  const Real lightest = beads.is_uniform() ? Real(1) : *std::ranges::min_element(beads.mass);
  const Real squared = beads.exponents.linear() ? Real(6) * beads.K
                                                : Real(3 * std::numbers::pi * std::numbers::pi) / (beads.tc * beads.tc);
  const Real fastest_mode = sqrt(squared / lightest);
  return Real(std::min(0.4, std::pow(1e4 * accuracy, 0.2))) / fastest_mode;
}
/// tc without an event after which contacts that stay closed are looked at.
constexpr double creeping = 50.0;

}  // namespace

template <class Real, class Ground>
LatticeEvents<Real, Ground>::LatticeEvents(const Lattice<Real>& lattice, double accuracy, const RunLimits& limits,
                                           const Ground& ground)
    : state_(lattice, ground),
      stop_(limits, 100'000 + 1'000 * lattice.count(), 10'000'000'000 + 20'000'000 * lattice.count()),
      closing_overlap_(smallest_overlap(lattice, accuracy)),
      schedule_(state_, closing_overlap_, Real(slow) * least_overlap(lattice, accuracy) / lattice.beads.tc),
      regrouping_(state_, schedule_, std::max(accuracy, double(lattice.rounding()) / 8.0),  // steps cannot do better
                  longest_step(lattice, accuracy)),
      energies_(state_) {}

template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::approach() {
  work_ += state_.beads.size();
  return energies_.approach(now_);
}

template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::held() {
  work_ += state_.beads.size();
  return energies_.held(now_);
}

/// Up to t nothing closed or opened since the last time.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::count_contact_time(const Real& t) {
  contact_time_ += Real(closed_) * (epoch_ + t - counted_to_);
  counted_to_ = epoch_ + t;
}

/// A time without contacts ends at t. Wait::change holds the kinetic energy until note_ending_uncertainty().
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::note_wait(const Real& t) {
  const Real length = epoch_ + t - last_touch_;
  if (length > waits_.longest.back().length) waits_.note({length, energies_.kinetic(t)});
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::close_contact(std::size_t i, const Neighbour<Real>& other, const Real& t) {
  count_contact_time(t);
  if (closed_ == 0 && contacts_ > 0 && !Ground::moves) note_wait(t);
  state_.touching[i].push_back(other);
  if (!other.is_wall()) state_.touching[other.bead].push_back(other.seen_from_there(static_cast<std::uint32_t>(i)));
  ++closed_;
  last_change_ = epoch_ + t;
  if (other.bead == Neighbour<Real>::bottom && wall_closed_ < 0) wall_closed_ = epoch_ + t;
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::open_contact(std::size_t i, const Neighbour<Real>& other, const Real& t) {
  const auto forget = [this](std::size_t bead, std::uint32_t with, std::int32_t image) {
    std::erase_if(state_.touching[bead], [&](const Neighbour<Real>& n) { return n.is(with, image); });
  };
  count_contact_time(t);
  forget(i, other.bead, other.image);
  if (!other.is_wall()) forget(other.bead, static_cast<std::uint32_t>(i), -other.image);
  --closed_;
  ++contacts_;
  last_touch_ = last_change_ = epoch_ + t;
  if (other.bead == Neighbour<Real>::bottom) wall_opened_ = epoch_ + t;
}

/// Newton's method for the time at which the gap opens or closes, where clusters can be stepped to it. False if it does
/// not, or only after the next event: then they are cut where it was predicted.
template <class Real, class Ground>
bool LatticeEvents<Real, Ground>::locate(Real& t, std::size_t i, const Neighbour<Real>& other,
                                         std::span<const std::size_t> whole) {
  using std::fabs;
  Real earliest = now_, latest = schedule_.next_time();
  for (const std::size_t id : whole) {
    latest = std::min(latest, state_.clusters[id].cluster->end());
    earliest = std::max(earliest, state_.clusters[id].cluster->begin());
  }
  const bool opens = state_.touches(i, other);
  for (int iteration = 0; iteration < 8 && !whole.empty(); ++iteration) {
    for (const std::size_t id : whole) state_.clusters[id].cluster->cut(t);
    const Motion<Real> now = state_.gap(i, other, t);
    const Real distance = opens ? Real(schedule_.open_from(now.u) - now.x) : Real(now.x + closing_overlap_),
               rate = opens ? Real(-now.u) : now.u;
    if (fabs(distance) <= Real(0.1) * closing_overlap_) return true;
    if (!(rate < 0)) return distance <= 0;  // too late for Newton, or a miss
    const Real next = std::max(Real(t - distance / rate), earliest);
    if (fabs(next - t) <= 4 * std::numeric_limits<Real>::epsilon() * t) return true;
    if (!(next <= latest)) return false;
    t = next;
  }
  return true;
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::change_gap(const Event& event) {
  const auto& list = state_.neighbours.of(event.bead);
  const auto found =
      std::ranges::find_if(list, [&](const Neighbour<Real>& n) { return n.is(event.other, event.image); });
  if (found == list.end()) return;
  const Neighbour<Real> other = *found;
  std::vector<std::size_t> whole;
  for (const std::size_t bead : {std::size_t(event.bead), std::size_t(other.bead)}) {
    const std::int32_t id = bead < state_.beads.size() ? state_.beads[bead].cluster : -1;
    if (id < 0 || !state_.clusters[std::size_t(id)].whole) continue;
    if (whole.empty() || whole[0] != std::size_t(id)) whole.push_back(std::size_t(id));
  }
  Real t = event.time;
  const bool changes = locate(t, event.bead, other, whole);
  now_ = t;
  ++state_.marks;
  std::vector<Placed> placed;
  for (const std::size_t id : whole) regrouping_.gather_cluster(id, t, placed);
  if (changes) {
    const bool opens = state_.touches(event.bead, other);
    if (!opens) close_contact(event.bead, other, t);
    regrouping_.gather_near(other.is_wall() ? std::vector{event.bead} : std::vector{event.bead, other.bead}, t, placed);
    if (opens) open_contact(event.bead, other, t);
  }
  regrouping_.restart(placed, t);
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::handle(const Event& event) {
  switch (event.kind) {
    case Kind::gap: return change_gap(event);
    case Kind::step: {
      ++state_.marks;
      std::vector<Placed> placed;
      regrouping_.gather_cluster(event.other, event.time, placed);
      return regrouping_.restart(placed, event.time);
    }
    case Kind::list: {  // meetings with those who were on the list before are known
      for (const Neighbour<Real>& fresh :
           std::vector(state_.neighbours.move(event.bead, state_.at(event.bead, event.time).q)))
        schedule_.predict_events(event.bead, fresh, event.time);
      schedule_.predict_list(event.bead, event.time);
    }
  }
}

/// Sets the clock to 0: at the beginning, with each period of the plate, and where nothing touches after a long time,
/// as times would lose digits. No cluster has guests then.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::begin_anew(const Real& t) {
  ++state_.marks;
  work_ += state_.beads.size();
  schedule_.clear();
  std::vector<Placed> placed;
  for (std::size_t id = 0; id < state_.clusters.size(); ++id)
    if (state_.clusters[id].in_use) regrouping_.gather_cluster(id, t, placed);
  for (std::uint32_t i = 0; i < state_.beads.size(); ++i) {
    if (state_.is_marked(i)) continue;
    const BeadState<Real> state = state_.at(i, t);
    state_.mark[i] = state_.marks;
    placed.push_back({i, state.q, state.v, State::never});
  }
  epoch_ += t;
  now_ = Real(0);
  regrouping_.restart(placed, Real(0));
}

template <class Real, class Ground>
Status LatticeEvents<Real, Ground>::why_stop() {
  if (regrouping_.step_underflow()) return Status::non_finite;
  const std::uint64_t work = std::exchange(work_, 1) + regrouping_.take_work();
  all_work_ += work;
  return stop_.why_stop(contacts_, all_work_, work);
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::show_at(const Real& t, std::span<Vec2<double>> q, std::span<Vec2<double>> v) const {
  for (std::size_t i = 0; i < state_.beads.size(); ++i) {
    const BeadState<Real> state = state_.at(i, t);
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
  const Event event = schedule_.take_next();
  now_ = std::max(now_, event.time);
  handle(event);
}

/// Sets outcome.end if the collision is over before the next event, at time t.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::look_for_end(LatticeOutcome<Real>& outcome, const Real& t) {
  const Real quiet = state_.lattice.quiet_time(), patience = std::max(quiet, Real(creeping) * state_.lattice.beads.tc);
  if (closed_ == 0 && quiet > 0 && epoch_ + t > last_touch_ + quiet) {
    outcome.end = End::quiet;
  } else if (closed_ == 0 && quiet == Real(0) && contacts_ > 0) {
    const Real change = energies_.later_change(approach(), now_);
    if (change <= Real(stop_.settle())) {
      outcome.remainder = change;
      outcome.end = change == Real(0) ? End::separated : End::settled;
    }
  } else if (closed_ > 0 && epoch_ + now_ > last_change_ + patience) {
    const Real change = energies_.later_change(held() + (quiet > 0 ? Real(0) : approach()), now_);
    if (change <= Real(stop_.settle())) {
      outcome.remainder = change;
      outcome.end = End::settled;
    }
    last_change_ = epoch_ + now_;
  }
}

template <class Real, class Ground>
template <class Watcher>
LatticeOutcome<Real> LatticeEvents<Real, Ground>::run(Watcher& watcher) {
  constexpr double longest_clock = 64.0;
  begin_anew(Real(0));
  LatticeOutcome<Real> outcome;
  while (outcome.end == End::none && (outcome.status = why_stop()) == Status::ok) {
    const Real t = schedule_.next_time();
    if constexpr (Watcher::observes) {
      show(watcher, t);
      if (watcher.done()) break;
    } else {
      look_for_end(outcome, t);
      if (outcome.end == End::quiet) break;
    }
    if (schedule_.is_empty()) {
      outcome.end = End::separated;
    } else if (outcome.end == End::none) {
      if (t > longest_clock * state_.lattice.beads.tc && closed_ == 0 && schedule_.next_kind() == Kind::gap) {
        begin_anew(t);
        continue;
      }
      handle_next();
    }
  }
  for (std::size_t i = 0; i < state_.beads.size(); ++i) outcome.velocity.push_back(state_.at(i, now_).v);
  for (const auto& touching : state_.touching)
    for (const Neighbour<Real>& other : touching)
      if (other.bead == Neighbour<Real>::bottom) wall_opened_ = epoch_ + now_;  // it is still closed
  outcome.t_k = wall_closed_ < 0 ? Real(0) : wall_opened_ - wall_closed_;
  outcome.x_max = regrouping_.x_max();
  outcome.contacts = contacts_;
  outcome.contact_time = contact_time_;
  if constexpr (!Watcher::observes)
    if (outcome.end == End::quiet) note_ending_uncertainty(outcome);
  return outcome;
}

/// Notes by how much eps_eff would differ if one of the waits had been the end; and, as the next contact is waited for
/// half as long again, if the present end had not been.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::note_ending_uncertainty(LatticeOutcome<Real>& outcome) {
  using std::fabs, std::sqrt;
  const Real latest = last_touch_ + Real(1.5) * state_.lattice.quiet_time(), E = energies_.kinetic(now_);
  outcome.waits = waits_;
  for (auto& wait : outcome.waits.longest)
    if (wait.length > 0) wait.change = fabs(Real(sqrt(wait.change) - sqrt(E))) / sqrt(energies_.energy_at_start());
  const Real next_change = energies_.later_change(approach(), now_);
  while (closed_ == 0 && why_stop() == Status::ok && epoch_ + schedule_.next_time() < latest) handle_next();
  outcome.waits.note({(closed_ > 0 ? epoch_ + now_ : latest) - last_touch_, next_change});
}

template <class Real, class Ground>
template <class Watcher>
LatticeOutcome<Real> LatticeEvents<Real, Ground>::follow(Watcher& watcher) requires(Ground::moves) {
  const Real period = state_.ground.period();
  const auto show_until = [&](const Real& t) {
    watcher.until(double(t), [this](double when, auto q, auto v) { show_at(Real(when), q, v); });
  };
  begin_anew(Real(0));
  const double at_start = energies_.energy(Real(0));
  LatticeOutcome<Real> outcome;
  while (!watcher.done() && (outcome.status = why_stop()) == Status::ok) {
    if (const Real t = schedule_.next_time(); t < period) {
      show_until(t);
      handle_next();
      continue;
    }
    show_until(period);
    count_contact_time(period);
    begin_anew(period);
    epoch_ = counted_to_ = Real(0);
    watcher.end_period(energies_.energy(Real(0)) - at_start, regrouping_.plate_work().in,
                       regrouping_.plate_work().lost);
  }
  if (outcome.status == Status::ok) outcome.end = End::periods;
  outcome.x_max = regrouping_.x_max();
  outcome.contacts = contacts_;
  outcome.contact_time = contact_time_;
  return outcome;
}

template class LatticeEvents<double>;
template class LatticeEvents<long double>;
template class LatticeEvents<double, Plate>;
template LatticeOutcome<double> LatticeEvents<double>::run(NullObserver&);
template LatticeOutcome<long double> LatticeEvents<long double>::run(NullObserver&);
template LatticeOutcome<double> LatticeEvents<double>::run(LatticeSamples&);
template LatticeOutcome<double> LatticeEvents<double, Plate>::follow(LatticeStatistics&);
template LatticeOutcome<double> LatticeEvents<double, Plate>::follow(VibratedLatticeSamples&);

}  // namespace sigmasweep
