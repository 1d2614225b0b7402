#include "solve/exact/lattice/events.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solve/observer/lattice_samples.hpp"

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

/// Of slowest_, in least overlaps a tc.
constexpr double slow = 1000.0;

/// Between the ends of a step of length h motions are interpolated by quintics, whose velocities are off by up to
/// 1.6e-4 omega (omega h)^5 of an amplitude, a tenth; the fastest mode of a triangular lattice has omega^2 = 6 K/m, and
/// 3 (pi/tc)^2 for what collides in tc. News past the reach are much less: with k = 1.5 K/m they change velocities by
/// k^3 h^7/7! of the jump of an acceleration.
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
/// Times closer to each other than this part of it are the same.
constexpr double no_time = 1e-6;

}  // namespace

template <class Real, class Ground>
LatticeEvents<Real, Ground>::LatticeEvents(const Lattice<Real>& lattice, double accuracy, const RunLimits& limits,
                                           const Ground& ground)
    : lattice_(lattice),
      accuracy_(std::max(accuracy, double(lattice.rounding()) / 8.0)),  // steps cannot do better
      stop_(limits, 100'000 + 1'000 * lattice.count(), 10'000'000'000 + 20'000'000 * lattice.count()),
      ground_(ground),
      neighbours_(lattice),
      closing_overlap_(smallest_overlap(lattice, accuracy)),
      slowest_(Real(slow) * least_overlap(lattice, accuracy) / lattice.beads.tc),
      longest_(longest_step(lattice, accuracy)),
      beads_(lattice.count()),
      touching_(lattice.count()),
      mark_(lattice.count()),
      slot_(lattice.count()) {
  for (std::size_t i = 0; i < beads_.size(); ++i) {
    if (!lattice.shift.empty()) beads_[i].q = lattice.shift[i];
    if constexpr (!Ground::moves) beads_[i].v = {Real(0), -lattice.beads.speed};
  }
}

template <class Real, class Ground>
bool LatticeEvents<Real, Ground>::touches(std::size_t i, const Neighbour<Real>& other) const {
  return std::ranges::any_of(touching_[i], [&](const Neighbour<Real>& n) { return n.is(other.bead, other.image); });
}

/// Up to t nothing closed or opened since the last time.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::count_contact_time(const Real& t) {
  contact_time_ += Real(closed_) * (epoch_ + t - counted_to_);
  counted_to_ = epoch_ + t;
}

/// A time without contacts ends at t. Kinetic energies for now, see note_ending_uncertainty().
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::note_wait(const Real& t) {
  const Real length = epoch_ + t - last_touch_;
  if (length > waits_.longest.back().length) waits_.note({length, kinetic(t)});
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::close_contact(std::size_t i, const Neighbour<Real>& other, const Real& t) {
  count_contact_time(t);
  if (closed_ == 0 && contacts_ > 0 && !Ground::moves) note_wait(t);
  touching_[i].push_back(other);
  if (!other.is_wall()) touching_[other.bead].push_back(other.seen_from_there(static_cast<std::uint32_t>(i)));
  ++closed_;
  last_change_ = epoch_ + t;
  if (other.bead == Neighbour<Real>::bottom && wall_closed_ < 0) wall_closed_ = epoch_ + t;
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::open_contact(std::size_t i, const Neighbour<Real>& other, const Real& t) {
  const auto forget = [this](std::size_t bead, std::uint32_t with, std::int32_t image) {
    std::erase_if(touching_[bead], [&](const Neighbour<Real>& n) { return n.is(with, image); });
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
  Real earliest = now_, latest = next_event();
  for (const std::size_t id : whole) {
    latest = std::min(latest, clusters_[id].cluster->end());
    earliest = std::max(earliest, clusters_[id].cluster->begin());
  }
  const bool opens = touches(i, other);
  for (int iteration = 0; iteration < 8 && !whole.empty(); ++iteration) {
    for (const std::size_t id : whole) clusters_[id].cluster->cut(t);
    const Motion<Real> now = gap(i, other, t);
    const Real distance = opens ? Real(-now.x) : Real(now.x + closing_overlap_), rate = opens ? Real(-now.u) : now.u;
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
  const auto& list = neighbours_.of(event.bead);
  const auto found =
      std::ranges::find_if(list, [&](const Neighbour<Real>& n) { return n.is(event.other, event.image); });
  if (found == list.end()) return;
  const Neighbour<Real> other = *found;
  std::vector<std::size_t> whole;
  for (const std::size_t bead : {std::size_t(event.bead), std::size_t(other.bead)}) {
    const std::int32_t id = bead < beads_.size() ? beads_[bead].cluster : -1;
    if (id < 0 || !clusters_[std::size_t(id)].whole) continue;
    if (whole.empty() || whole[0] != std::size_t(id)) whole.push_back(std::size_t(id));
  }
  Real t = event.time;
  const bool changes = locate(t, event.bead, other, whole);
  now_ = t;
  ++marks_;
  std::vector<Placed> placed;
  for (const std::size_t id : whole) gather_cluster(id, t, placed);
  if (changes) {
    const bool opens = touches(event.bead, other);
    if (!opens) close_contact(event.bead, other, t);
    gather_near(other.is_wall() ? std::vector{event.bead} : std::vector{event.bead, other.bead}, t, placed);
    if (opens) open_contact(event.bead, other, t);
  }
  restart(placed, t);
}

/// Beads that touch one another are clusters, the others fly.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::restart(std::vector<Placed>& placed, const Real& t) {
  // Clusters around that are over at the same time come along.
  for (std::size_t k = 0; k < placed.size(); ++k)
    for (const Neighbour<Real>& other : touching_[placed[k].bead])
      if (!other.is_wall() && mark_[other.bead] != marks_ && until(other.bead) - t < Real(no_time) * longest_)
        gather_cluster(std::size_t(beads_[other.bead].cluster), t, placed);
  std::vector<Real> span_of;  // by slot
  for (const Placed& p : placed) {
    beads_[p.bead] = {p.q, p.v, t, -1, 0, beads_[p.bead].version + 1};
    slot_[p.bead] = static_cast<std::uint32_t>(span_of.size());
    span_of.push_back(p.span);
    renew_list(p.bead, t);
  }
  std::vector<std::uint32_t> group;
  constexpr std::int32_t found = -2;
  for (const Placed& p : placed) {
    if (beads_[p.bead].cluster != -1) continue;
    if (touching_[p.bead].empty()) {
      enqueue(leaves(p.bead, t), Kind::list, p.bead, {});
      continue;
    }
    group.assign(1, p.bead);
    beads_[p.bead].cluster = found;
    Real span = never;
    for (std::size_t k = 0; k < group.size(); ++k) {
      span = std::min(span, span_of[slot_[group[k]]]);
      for (const Neighbour<Real>& other : touching_[group[k]])
        if (!other.is_wall() && mark_[other.bead] == marks_ && beads_[other.bead].cluster == -1) {
          beads_[other.bead].cluster = found;
          group.push_back(other.bead);
        }
    }
    restart_group(group, span, t);
  }
  for (const Placed& p : placed) predict_events(p.bead, t);
}

/// When the next step of clusters that are not whole has to end.
template <class Real, class Ground>
Real LatticeEvents<Real, Ground>::next_sync_time(const Real& t) const {
  using std::floor;
  return longest_ * (floor(Real(t / longest_ + Real(no_time))) + 1);
}

/// The next step of beads that touch each other.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::restart_group(std::span<const std::uint32_t> group, const Real& span, const Real& t) {
  const std::size_t id = new_cluster(group.size());
  Held& held = clusters_[id];
  Cluster& cluster = *held.cluster;
  for (const std::uint32_t i : group) cluster.add(i, beads_[i].q, beads_[i].v);
  for (std::size_t place = 0; place < group.size(); ++place) {
    beads_[group[place]].cluster = std::int32_t(id);
    beads_[group[place]].place = slot_[group[place]] = static_cast<std::uint32_t>(place);
  }
  Real longest = neighbours_.leeway() / (4 * cluster.fastest());
  std::vector<std::uint32_t> guests;
  for (const std::uint32_t i : group)
    for (const Neighbour<Real>& other : touching_[i]) {
      if (other.is_wall()) {
        cluster.add_contact(slot_[i], 0, other);
      } else if (beads_[other.bead].cluster == std::int32_t(id)) {
        if (i < other.bead) cluster.add_contact(slot_[i], slot_[other.bead], other);
      } else {
        if (std::ranges::find(guests, other.bead) == guests.end()) {
          const Bead& guest = beads_[other.bead];
          guests.push_back(other.bead);
          const Cluster& home = *clusters_[std::size_t(guest.cluster)].cluster;
          slot_[other.bead] = cluster.add_guest(other.bead, home.motion(guest.place));
          longest = std::min(longest, Real(until(other.bead) - t));
        }
        cluster.add_contact(slot_[i], slot_[other.bead], other);
      }
    }
  held.whole = guests.empty() && group.size() <= max_whole;
  if (!held.whole) longest = std::min(longest, Real(next_sync_time(t) - t));
  if (!held.whole || span < never) cluster.expect(held.whole ? span : longest);
  ++held.version;
  if (!cluster.step(t, longest)) step_underflow_ = true;
  queue_.push({cluster.end(), Kind::step, 0, std::uint32_t(id), 0, held.version, 0});
}

/// Makes the list of a bead that has gone half its leeway or more anew.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::renew_list(std::size_t i, const Real& t) {
  const Vec2<Real> q = at(i, t).q, gone = q - neighbours_.anchor(i);
  if (4 * dot(gone, gone) > neighbours_.leeway() * neighbours_.leeway()) neighbours_.move(i, q);
}

template <class Real, class Ground>
void LatticeEvents<Real, Ground>::handle(const Event& event) {
  switch (event.kind) {
    case Kind::gap: return change_gap(event);
    case Kind::step: {
      ++marks_;
      std::vector<Placed> placed;
      gather_cluster(event.other, event.time, placed);
      return restart(placed, event.time);
    }
    case Kind::list: {  // meetings with those who were on the list before are known
      for (const Neighbour<Real>& fresh : std::vector(neighbours_.move(event.bead, at(event.bead, event.time).q)))
        predict_events(event.bead, fresh, event.time);
      enqueue(leaves(event.bead, event.time), Kind::list, event.bead, {});
    }
  }
}

/// The clock starts: at the beginning, with a period of the plate, and where nothing touches after a long time, as
/// times would lose digits. All clusters there are are whole.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::begin_anew(const Real& t) {
  ++marks_;
  work_ += beads_.size();
  queue_ = {};
  std::vector<Placed> placed;
  for (std::size_t id = 0; id < clusters_.size(); ++id)
    if (clusters_[id].in_use) gather_cluster(id, t, placed);
  for (std::uint32_t i = 0; i < beads_.size(); ++i) {
    if (mark_[i] == marks_) continue;
    const BeadState<Real> state = at(i, t);
    mark_[i] = marks_;
    placed.push_back({i, state.q, state.v, never});
  }
  epoch_ += t;
  now_ = Real(0);
  restart(placed, Real(0));
}

template class LatticeEvents<double>;
template class LatticeEvents<long double>;
template class LatticeEvents<double, Plate>;

}  // namespace sigmasweep
