#include "solve/exact/lattice/regroup.hpp"

#include <algorithm>
#include <cmath>

namespace sigmasweep {
namespace {

/// Distance from an event, in contacts, up to which motions change at once.
template <class Ground>
constexpr int reach = Ground::moves ? 1'000'000 : 2;
/// Large clusters without beads that are kept.
constexpr std::size_t max_large = 4;

/// Times closer to each other than this part of the longest step are the same.
constexpr double no_time = 1e-6;

}  // namespace

/// A cluster for a group of `count` beads. Large ones are kept apart: small clusters do not need their memory, and to
/// allocate it anew at each sync time takes longer than the step.
template <class Real, class Ground>
std::size_t Regrouping<Real, Ground>::new_cluster(std::size_t count) {
  if (free_clusters_.empty()) {
    free_clusters_.push_back(state_.clusters.size());
    state_.clusters.emplace_back();
  }
  const std::size_t id = free_clusters_.back();
  free_clusters_.pop_back();
  typename State::Held& held = state_.clusters[id];
  if (count > max_whole && !large_.empty()) {
    held.cluster = std::move(large_.back());
    large_.pop_back();
  }
  if (!held.cluster)
    held.cluster = std::make_unique<Cluster>(state_.lattice, Real(accuracy_), state_.ground,
                                             schedule_.resting_overlap(), schedule_.slowest());
  held.cluster->clear();
  held.counted = held.cluster->work_done();
  held.in_use = true;
  return id;
}

/// The beads that cluster `id` still has restart at t, its end or a time to which it is cut.
template <class Real, class Ground>
void Regrouping<Real, Ground>::gather_cluster(std::size_t id, const Real& t, std::vector<Placed>& placed) {
  typename State::Held& held = state_.clusters[id];
  Cluster& cluster = *held.cluster;
  if (held.whole) cluster.cut(t);
  const auto owns = [&](std::size_t place) {
    const typename State::Bead& bead = state_.beads[cluster.beads()[place]];
    return bead.cluster == std::int32_t(id) && bead.place == place;
  };
  x_max_ = cluster.deepest(x_max_, owns);
  if constexpr (Ground::moves) plate_work_ += cluster.work();
  for (std::size_t place = 0; place < cluster.beads().size(); ++place) {
    const std::uint32_t i = cluster.beads()[place];
    if (!owns(place) || state_.is_marked(i)) continue;
    const BeadState<Real> state = cluster.at(place, t);
    state_.mark[i] = state_.marks;
    placed.push_back({i, state.q, state.v, cluster.next_span()});
  }
  work_ += cluster.work_done() - held.counted;
  held.in_use = false;
  ++held.version;
  free_clusters_.push_back(id);
  if (cluster.beads().size() > max_whole) {
    if (large_.size() < max_large) large_.push_back(std::move(held.cluster));
    held.cluster.reset();
  }
}

/// x_max of bead i's contacts in a step that it will not end.
template <class Real, class Ground>
void Regrouping<Real, Ground>::note_overlaps(std::size_t i, const Real& t) {
  const auto begin = [this, &t](std::size_t bead) {  // one that has just been touched may be in none
    return state_.beads[bead].cluster < 0 ? t
                                          : state_.clusters[std::size_t(state_.beads[bead].cluster)].cluster->begin();
  };
  for (const Neighbour<Real>& other : state_.touching[i]) {
    const Real from = other.is_wall() ? begin(i) : std::max(begin(i), begin(other.bead));
    if (!(from < t)) continue;
    const Motion<Real> now = state_.gap(i, other, t);
    if (now.u > 0) x_max_ = largest_between(-state_.gap(i, other, from), -now, Real(t - from), x_max_);
  }
}

/// These beads and those within reach restart at t.
template <class Real, class Ground>
void Regrouping<Real, Ground>::gather_near(std::vector<std::uint32_t> layer, const Real& t,
                                           std::vector<Placed>& placed) {
  const auto take = [&](std::uint32_t bead) {
    const std::int32_t id = state_.beads[bead].cluster;
    if (id >= 0 && state_.clusters[std::size_t(id)].whole) return gather_cluster(std::size_t(id), t, placed);
    const BeadState<Real> state = state_.at(bead, t);
    Real span = State::never;
    if (id >= 0) {
      span = state_.clusters[std::size_t(id)].cluster->after_cut(t);
      note_overlaps(bead, t);
    }
    state_.mark[bead] = state_.marks;
    placed.push_back({bead, state.q, state.v, span});
  };
  std::vector<std::uint32_t> next;
  for (const std::uint32_t bead : layer)
    if (!state_.is_marked(bead)) take(bead);
  for (int distance = 0; distance < reach<Ground> && !layer.empty(); ++distance, layer.swap(next)) {
    next.clear();
    for (const std::uint32_t bead : layer)
      for (const Neighbour<Real>& other : state_.touching[bead]) {
        if (other.is_wall() || state_.is_marked(other.bead)) continue;
        take(other.bead);
        next.push_back(other.bead);
      }
  }
}

/// Beads that touch one another are clusters, the others fly.
template <class Real, class Ground>
void Regrouping<Real, Ground>::restart(std::vector<Placed>& placed, const Real& t) {
  // Clusters around that are over at the same time come along.
  for (std::size_t k = 0; k < placed.size(); ++k)
    for (const Neighbour<Real>& other : state_.touching[placed[k].bead])
      if (!other.is_wall() && !state_.is_marked(other.bead) && state_.until(other.bead) - t < Real(no_time) * longest_)
        gather_cluster(std::size_t(state_.beads[other.bead].cluster), t, placed);
  std::vector<Real> span_of;  // by slot
  for (const Placed& p : placed) {
    state_.beads[p.bead] = {p.q, p.v, t, -1, 0, state_.beads[p.bead].version + 1};
    slot_[p.bead] = static_cast<std::uint32_t>(span_of.size());
    span_of.push_back(p.span);
    renew_list(p.bead, t);
  }
  std::vector<std::uint32_t> group;
  constexpr std::int32_t found = -2;
  for (const Placed& p : placed) {
    if (state_.beads[p.bead].cluster != -1) continue;
    if (state_.touching[p.bead].empty()) {
      schedule_.predict_list(p.bead, t);
      continue;
    }
    group.assign(1, p.bead);
    state_.beads[p.bead].cluster = found;
    Real span = State::never;
    for (std::size_t k = 0; k < group.size(); ++k) {
      span = std::min(span, span_of[slot_[group[k]]]);
      for (const Neighbour<Real>& other : state_.touching[group[k]])
        if (!other.is_wall() && state_.is_marked(other.bead) && state_.beads[other.bead].cluster == -1) {
          state_.beads[other.bead].cluster = found;
          group.push_back(other.bead);
        }
    }
    restart_group(group, span, t);
  }
  for (const Placed& p : placed) schedule_.predict_events(p.bead, t);
}

/// When the next step of clusters that are not whole has to end.
template <class Real, class Ground>
Real Regrouping<Real, Ground>::next_sync_time(const Real& t) const {
  using std::floor;
  return longest_ * (floor(Real(t / longest_ + Real(no_time))) + 1);
}

/// The next step of beads that touch each other.
template <class Real, class Ground>
void Regrouping<Real, Ground>::restart_group(std::span<const std::uint32_t> group, const Real& span, const Real& t) {
  const std::size_t id = new_cluster(group.size());
  typename State::Held& held = state_.clusters[id];
  Cluster& cluster = *held.cluster;
  for (const std::uint32_t i : group) cluster.add(i, state_.beads[i].q, state_.beads[i].v);
  for (std::size_t place = 0; place < group.size(); ++place) {
    state_.beads[group[place]].cluster = std::int32_t(id);
    state_.beads[group[place]].place = slot_[group[place]] = static_cast<std::uint32_t>(place);
  }
  Real longest = state_.neighbours.leeway() / (4 * cluster.fastest());
  std::vector<std::uint32_t> guests;
  for (const std::uint32_t i : group)
    for (const Neighbour<Real>& other : state_.touching[i]) {
      if (other.is_wall()) {
        cluster.add_contact(slot_[i], 0, other);
      } else if (state_.beads[other.bead].cluster == std::int32_t(id)) {
        if (i < other.bead) cluster.add_contact(slot_[i], slot_[other.bead], other);
      } else {
        if (std::ranges::find(guests, other.bead) == guests.end()) {
          const typename State::Bead& guest = state_.beads[other.bead];
          guests.push_back(other.bead);
          const Cluster& home = *state_.clusters[std::size_t(guest.cluster)].cluster;
          slot_[other.bead] = cluster.add_guest(other.bead, home.motion(guest.place));
          longest = std::min(longest, Real(state_.until(other.bead) - t));
        }
        cluster.add_contact(slot_[i], slot_[other.bead], other);
      }
    }
  held.whole = guests.empty() && group.size() <= max_whole;
  if (!held.whole) longest = std::min(longest, Real(next_sync_time(t) - t));
  if (!held.whole || span < State::never) cluster.expect(held.whole ? span : longest);
  ++held.version;
  if (!cluster.step(t, longest)) step_underflow_ = true;
  schedule_.add_step(cluster.end(), id, held.version);
}

/// Makes the list of a bead that has gone half its leeway or more anew.
template <class Real, class Ground>
void Regrouping<Real, Ground>::renew_list(std::size_t i, const Real& t) {
  const Vec2<Real> q = state_.at(i, t).q, gone = q - state_.neighbours.anchor(i);
  if (4 * dot(gone, gone) > state_.neighbours.leeway() * state_.neighbours.leeway()) state_.neighbours.move(i, q);
}

template class Regrouping<double, FixedWall>;
template class Regrouping<long double, FixedWall>;
template class Regrouping<double, Plate>;

}  // namespace sigmasweep
