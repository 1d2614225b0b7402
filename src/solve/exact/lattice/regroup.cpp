#include <algorithm>

#include "solve/exact/lattice/events.hpp"

/// Who restarts at an event, and where clusters come from.
namespace sigmasweep {
namespace {

/// In contacts: how far from an event motions change at once.
template <class Ground>
constexpr int reach = Ground::moves ? 1'000'000 : 2;
/// Large clusters without beads that are kept.
constexpr std::size_t max_large = 4;

}  // namespace

/// For a group of `count` beads. Large ones go round by themselves: small clusters need not their memory, and to ask
/// for it anew at each beat takes longer than the beat.
template <class Real, class Ground>
std::size_t LatticeEvents<Real, Ground>::new_cluster(std::size_t count) {
  if (free_clusters_.empty()) {
    free_clusters_.push_back(clusters_.size());
    clusters_.emplace_back();
  }
  const std::size_t id = free_clusters_.back();
  free_clusters_.pop_back();
  Held& held = clusters_[id];
  if (count > max_whole && !large_.empty()) {
    held.cluster = std::move(large_.back());
    large_.pop_back();
  }
  if (!held.cluster) held.cluster = std::make_unique<Cluster>(lattice_, Real(accuracy_), ground_);
  held.cluster->clear();
  held.counted = held.cluster->work_done();
  held.in_use = true;
  return id;
}

/// The beads that cluster `id` still has restart at t, its end or a time to which it is cut.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::gather_cluster(std::size_t id, const Real& t, std::vector<Placed>& placed) {
  Held& held = clusters_[id];
  Cluster& cluster = *held.cluster;
  if (held.whole) cluster.cut(t);
  const auto owns = [&](std::size_t place) {
    const Bead& bead = beads_[cluster.beads()[place]];
    return bead.cluster == std::int32_t(id) && bead.place == place;
  };
  x_max_ = cluster.deepest(x_max_, owns);
  if constexpr (Ground::moves) work_done_ += cluster.work();
  for (std::size_t place = 0; place < cluster.beads().size(); ++place) {
    const std::uint32_t i = cluster.beads()[place];
    if (!owns(place) || mark_[i] == marks_) continue;
    const BeadState<Real> state = cluster.at(place, t);
    mark_[i] = marks_;
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
void LatticeEvents<Real, Ground>::note_overlaps(std::size_t i, const Real& t) {
  const auto begin = [this, &t](std::size_t bead) {  // one that has just been touched may be in none
    return beads_[bead].cluster < 0 ? t : clusters_[std::size_t(beads_[bead].cluster)].cluster->begin();
  };
  for (const Neighbour<Real>& other : touching_[i]) {
    const Real from = other.is_wall() ? begin(i) : std::max(begin(i), begin(other.bead));
    if (!(from < t)) continue;
    const Motion<Real> now = gap(i, other, t);
    if (now.u > 0) x_max_ = largest_between(-gap(i, other, from), -now, Real(t - from), x_max_);
  }
}

/// These beads and those within reach restart at t.
template <class Real, class Ground>
void LatticeEvents<Real, Ground>::gather_near(std::vector<std::uint32_t> layer, const Real& t,
                                              std::vector<Placed>& placed) {
  const auto take = [&](std::uint32_t bead) {
    const std::int32_t id = beads_[bead].cluster;
    if (id >= 0 && clusters_[std::size_t(id)].whole) return gather_cluster(std::size_t(id), t, placed);
    const BeadState<Real> state = at(bead, t);
    Real span = never;
    if (id >= 0) {
      span = clusters_[std::size_t(id)].cluster->after_cut(t);
      note_overlaps(bead, t);
    }
    mark_[bead] = marks_;
    placed.push_back({bead, state.q, state.v, span});
  };
  std::vector<std::uint32_t> next;
  for (const std::uint32_t bead : layer)
    if (mark_[bead] != marks_) take(bead);
  for (int distance = 0; distance < reach<Ground> && !layer.empty(); ++distance, layer.swap(next)) {
    next.clear();
    for (const std::uint32_t bead : layer)
      for (const Neighbour<Real>& other : touching_[bead]) {
        if (other.is_wall() || mark_[other.bead] == marks_) continue;
        take(other.bead);
        next.push_back(other.bead);
      }
  }
}

template class LatticeEvents<double>;
template class LatticeEvents<long double>;
template class LatticeEvents<double, Plate>;

}  // namespace sigmasweep
