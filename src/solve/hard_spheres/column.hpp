#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energies.hpp"
#include "numerics/tournament.hpp"
#include "solve/hard_spheres/cluster.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "solve/hard_spheres/hit_memory.hpp"
#include "solve/hard_spheres/late_collisions.hpp"
#include "solve/hard_spheres/scales.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {

/// Contacts are numbered k = 0 (the wall) to N-1; units are the speed, length_of() and the mean bead's mass. The state
/// is each contact's gap at its own time `since` and its closing speed u (> 0: approaching), so neither is a small
/// difference of large numbers.
template <class Real>
class HardSphereColumn {
 public:
  HardSphereColumn(const Column<Real>& column, const HardSphereSettings& settings, const RunLimits& limits)
      : contacts_(static_cast<std::size_t>(column.N)),
        e_(column.eps),
        e_wall_(column.eps_wall),
        settings_(settings),
        stop_(limits, own_limit(column.N), std::numeric_limits<std::uint64_t>::max()),
        state_(contacts_),
        spread_(spread(column.mass)),
        due_(contacts_),
        impacts_(contacts_),
        touching_gap_(settings.same_time) {
    if (settings.remember_hits) hits_.emplace();
    const double N = static_cast<double>(column.N);
    if (!column.mass.empty() || !column.gaps.empty()) settings_.same_time *= 1e-3;  // no symmetry makes times the same
    const Real length = length_of(column);
    if (settings_.rule == EdRule::tc) memory_ = column.gap > 0 ? Real(column.tc * column.speed / length) : infinity;
    for (std::size_t k = 0; k < contacts_; ++k) state_[k].gap = column.initial_gap(k) / length;
    state_[0].above = 1;
    if (!column.mass.empty()) take_masses(column.mass);
    settled_below_ = 2 * spread_ * std::sqrt(N * stop_.settle());
    state_[0].u = 1;
    schedule(0);
  }

  /// Runs the collision with an observer, NullObserver or Samples; it may end with the last sample.
  template <class Watcher>
  Outcome<Real> run(Watcher& watcher) {
    show(watcher, 0.0);
    while (outcome_.end == End::none) {
      if (const Status stop = stop_.why_stop(outcome_.contacts, 0, 1); stop != Status::ok) {
        if (stop == Status::event_limit && is_dissipated())
          outcome_.end = End::settled;
        else
          outcome_.status = stop;
        break;
      }
      if (const std::size_t k = impacts_.first(); impacts_.time_of(k) < 0)
        meet(k);
      else
        advance(watcher);
      if constexpr (Watcher::observes)
        if (watcher.done()) break;
    }
    outcome_.velocity = velocities();
    outcome_.t_k = last_wall_ - std::max(first_wall_, Real(0));
    return outcome_;
  }

  /// Adds to the outcome of a run() that settled what follows without energy to speak of: the end, if the beads part,
  /// with all collisions and the whole t_k; or a collapse. Velocities stay: what they still change is in the error.
  void add_late_collisions(Outcome<Real>& outcome) const {
    const auto wide = [](const Real& x) { return static_cast<long double>(x); };
    std::vector<Approach> contacts;
    for (std::size_t k = 0; k < contacts_; ++k)
      contacts.push_back({wide(gap_now(k)), wide(state_[k].u), wide(state_[k].below), wide(state_[k].above)});
    const LateCollisions late = late_collisions(std::move(contacts), wide(e_), wide(e_wall_));
    if (late.status == Status::collapsed) outcome.status = Status::collapsed;
    if (late.end != End::separated) return;
    outcome.end = End::separated;
    outcome.contacts += late.contacts;
    if (!(late.last_wall < 0.0L)) outcome.t_k = now_ + Real(late.last_wall) - std::max(first_wall_, Real(0));
  }

  /// Error of eps_eff, after run(), by the finite resolution of time. In a series of ever faster collisions, finite or
  /// infinite, times become indistinguishable, and velocities are uncertain by the relative speeds of the beads. The
  /// error is the largest of these speeds, times the rounding error of time relative to the time until the next
  /// collision.
  Real clock_resolution_error() const {
    Real largest = 0;
    for (const Contact& contact : state_) largest = std::max(largest, contact.clock_error);
    return largest;
  }

 private:
  inline static const Real infinity = std::numeric_limits<Real>::infinity();
  /// Fraction of the time so far within which a pair collides again almost at once.
  static constexpr double again = 1e-6;
  /// Number of rounding errors of time in a series of collisions.
  static constexpr double roundings = 64.0;

  struct Contact {
    Real gap = 0, u = 0, since = 0;
    Real last = -infinity;          ///< time of the last collision
    Real clock_error = 0;           ///< see clock_resolution_error()
    Real below = 0.5, above = 0.5;  ///< share of the lower and the upper bead in a change of u, by their masses
  };

  /// Takes samples up to and at `time`, for which the present flights are valid.
  template <class Watcher>
  void show(Watcher& watcher, const Real& time) const {
    if constexpr (Watcher::observes)
      watcher.until(time, [this](const Real& t, auto x, auto u) {
        for (std::size_t k = 0; k < contacts_; ++k) {
          x[k] = -gap_at(k, t);
          u[k] = state_[k].u;
        }
      });
  }

  static std::uint64_t own_limit(std::int64_t beads) {
    const double N = static_cast<double>(beads);
    return static_cast<std::uint64_t>(std::min(1e7 + 10.0 * N * N, 2e8));
  }

  void take_masses(const std::vector<Real>& mass) {
    mass_.assign(1, infinity);  // the wall
    mass_.insert(mass_.end(), mass.begin(), mass.end());
    for (std::size_t k = 0; k < contacts_; ++k) {
      state_[k].below = 1.0 / (1.0 + mass_[k] / mass_[k + 1]);
      state_[k].above = 1.0 / (1.0 + mass_[k + 1] / mass_[k]);
    }
  }

  std::vector<double> masses_from(std::size_t contact) const {
    std::vector<double> mass;
    for (std::size_t k = contact; k < mass_.size(); ++k) mass.push_back(static_cast<double>(mass_[k]));
    return mass;
  }
  std::span<const Real> masses() const { return std::span(mass_).subspan(mass_.empty() ? 0 : 1); }

  /// Advances to the time of the next collision. All contacts that collide then become touching.
  template <class Watcher>
  void advance(Watcher& watcher) {
    if (hits_ && hits_->is_watching()) keep_aftermath();
    std::size_t k = due_.first();
    show(watcher, due_.time_of(k));
    if (due_.time_of(k) == infinity) {
      outcome_.end = End::separated;
      return;
    }
    if (is_settled(k)) {
      outcome_.end = End::settled;
      return;
    }
    now_ = due_.time_of(k);
    for (; same_as_now(due_.time_of(k)); k = due_.first()) touch(k);
  }

  bool same_as_now(const Real& time) const { return time - now_ <= settings_.same_time * now_; }

  /// Whether the collision is settled. Contact k, the next to collide, can change eps_eff by at least m_ij u^2/(4 M)
  /// with m_ij = 2 m_i m_j/(m_i + m_j) and the mass M of the column, so that it is checked only when this is small, and
  /// not at every collision. It is not settled during a series of ever faster collisions.
  bool is_settled(std::size_t k) {
    const Contact& contact = state_[k];
    if (contact.u > settled_below_ || outcome_.contacts < next_look_) return false;
    if (is_again(contact, due_.time_of(k))) return false;
    next_look_ = outcome_.contacts + contacts_;
    return is_dissipated();
  }

  /// Later collisions can change eps_eff by next to nothing.
  bool is_dissipated() const { return residual_dissipation<Real>(velocities(), Real(1), masses()) < stop_.settle(); }

  static bool is_again(const Contact& contact, const Real& time) { return time - contact.last <= again * time; }

  void touch(std::size_t k) {
    if (hits_ && hits_->is_watching() && !is_in(hits_->watched(), k)) hits_->forget_watched();
    state_[k].gap = 0;
    state_[k].since = now_;
    due_.remove(k);
    impacts_.set(k, -state_[k].u);  // LRV: the fastest is first
  }

  /// The collision of the touching contact that approaches fastest, or its collapse.
  void meet(std::size_t k) {
    const Contact& contact = state_[k];
    const bool collapsed = contact.u < settings_.collapsed_speed && is_again(contact, now_);
    const bool predicts = settings_.predict_collapse && mass_.empty();
    if (memory_ == 0 && (collapsed || (predicts && outcome_.contacts >= next_try_))) {
      find_touching(k);
      next_try_ = outcome_.contacts + 16 + touching_.size();
      const Cluster cluster = cluster_around(k - lowest_, touching_, lowest_ == 0, masses_from(lowest_));
      if (predicts && will_collapse(cluster, static_cast<double>(e_)))
        clear_clock_errors(cluster);
      else if (!collapsed)
        return collide(k);
      return collapse(cluster);
    }
    collide(k);
  }

  /// Whether a collision is elastic in the TC model: one of the two beads has collided less than tc ago. Simultaneous
  /// times are equal even if tc is below the resolution of time; exactly tc is not less than tc.
  bool is_elastic(std::size_t k) const {
    Real last = state_[k].last;
    if (k > 0) last = std::max(last, state_[k - 1].last);
    if (k + 1 < contacts_) last = std::max(last, state_[k + 1].last);
    const Real resolution = settings_.same_time * now_;
    return now_ - last < std::max(Real(memory_ - resolution), resolution);
  }

  /// A collision, u -> -e u. The change (1 + e) u is shared by the two beads according to their masses; at the wall it
  /// belongs to the bead.
  void collide(std::size_t k) {
    if (hits_ && !hits_->is_watching() && repeat_or_watch(k)) return;
    Contact& contact = state_[k];
    const Real u = contact.u, e = memory_ > 0 && is_elastic(k) ? Real(1) : k == 0 ? e_wall_ : e_;
    const Real change = (1 + e) * u;
    contact.u = -e * u;
    contact.last = now_;
    impacts_.remove(k);
    if (k > 0) change_rate(k - 1, contact.below * change);
    if (k + 1 < contacts_) change_rate(k + 1, contact.above * change);
    ++outcome_.contacts;
    if (k > 0) return;
    if (first_wall_ < 0) first_wall_ = now_;
    last_wall_ = now_;
  }

  /// Changes the closing speed of a contact next to a collision by `change`.
  void change_rate(std::size_t k, const Real& change) {
    using std::abs;
    if (hits_ && hits_->is_watching()) hits_->note_change(k, change);
    Contact& contact = state_[k];
    contact.gap = gap_now(k);
    contact.since = now_;
    const Real u = contact.u + change;
    contact.u = abs(u) <= cancelled<Real> * abs(change) ? Real(0) : u;
    schedule(k);
  }

  Real gap_now(std::size_t k) const { return gap_at(k, now_); }
  Real gap_at(std::size_t k, const Real& time) const {
    const Contact& contact = state_[k];
    return std::max(Real(contact.gap - contact.u * (time - contact.since)), Real(0));
  }

  void schedule(std::size_t k) {
    Contact& contact = state_[k];
    if (!(contact.u > 0)) {
      due_.remove(k);
      impacts_.remove(k);
      return;
    }
    const Real wait = contact.gap / contact.u, due = contact.since + wait;
    if (wait <= again * now_ && contact.gap > 0) note_clock_error(contact, wait);
    if (same_as_now(due)) {
      touch(k);
    } else {
      impacts_.remove(k);
      due_.set(k, due);
    }
  }

  void note_clock_error(Contact& contact, const Real& wait) {
    const Real share = roundings * std::numeric_limits<Real>::epsilon() * now_ / wait;
    contact.clock_error = std::max(contact.clock_error, Real(std::min(share, Real(1)) * contact.u));
  }

  void find_touching(std::size_t k) {
    // A contact that recedes faster than all others together can close it stays open.
    using std::abs;
    const Real limit = spread_ * static_cast<double>(contacts_) * state_[k].u;
    const auto touches = [&](std::size_t j) { return gap_now(j) <= touching_gap_ && abs(state_[j].u) <= limit; };
    lowest_ = k;
    while (lowest_ > 0 && touches(lowest_ - 1)) --lowest_;
    touching_.clear();
    for (std::size_t j = lowest_; j <= k || (j < contacts_ && touches(j)); ++j)
      touching_.push_back(static_cast<double>(state_[j].u));
  }

  /// Clears the clock errors in a cluster that is certain to collapse, because its beads stay together in any case.
  void clear_clock_errors(const Cluster& cluster) {
    for (std::size_t j = 0; j + 1 < cluster.beads; ++j) state_[lowest_ + cluster.first + j].clock_error = 0;
  }

  /// Replaces the infinitely many collisions of a collapse.
  void collapse(const Cluster& cluster) {
    outcome_.status = Status::collapsed;
    const std::size_t first = lowest_ + cluster.first, end = first + cluster.beads - 1;
    if (hits_ && hits_->is_watching() && !(is_in(hits_->watched(), first) && is_in(hits_->watched(), end - 1)))
      hits_->forget_watched();
    for (std::size_t j = first; j < end; ++j) rest(j);
    if (first > 0) change_rate(first - 1, -cluster.bottom_change);
    if (end < contacts_) change_rate(end, cluster.top_change);
    if (cluster.wall) last_wall_ = now_;
    ++outcome_.contacts;
  }

  static bool is_in(const Hit& hit, std::size_t k) { return hit.lowest <= k && k <= hit.highest; }

  /// The run of touching contacts around k, if all others of them are at rest.
  std::optional<Hit> hit_at_rest(std::size_t k) const {
    const auto touches = [&](std::size_t j) { return gap_now(j) == 0; };
    Hit hit{k, k, k};
    for (; hit.lowest > 0 && touches(hit.lowest - 1); --hit.lowest)
      if (state_[hit.lowest - 1].u != 0) return std::nullopt;
    for (; hit.highest + 1 < contacts_ && touches(hit.highest + 1); ++hit.highest)
      if (state_[hit.highest + 1].u != 0) return std::nullopt;
    if (hit.lowest == hit.highest) return std::nullopt;
    return hit;
  }

  /// A collision of contact k in a cluster at rest: once seen, it is not computed again.
  bool repeat_or_watch(std::size_t k) {
    const std::optional<Hit> hit = hit_at_rest(k);
    if (!hit) return false;
    const Real speed = state_[k].u;
    const Aftermath<Real>* known = hits_->find(*hit, speed);
    if (!known) {
      hits_->watch(*hit, speed);
      return false;
    }
    for (std::size_t j = hit->lowest; j <= hit->highest; ++j) {
      rest(j);
      state_[j].u = known->u[j - hit->lowest] * speed;
    }
    if (hit->lowest > 0) change_rate(hit->lowest - 1, known->below * speed);
    if (hit->highest + 1 < contacts_) change_rate(hit->highest + 1, known->above * speed);
    if (hit->lowest == 0) last_wall_ = now_;
    ++outcome_.contacts;
    return true;
  }

  void keep_aftermath() {
    std::vector<Real> u;
    for (std::size_t j = hits_->watched().lowest; j <= hits_->watched().highest; ++j) u.push_back(state_[j].u);
    hits_->keep_watched(std::move(u));
  }

  void rest(std::size_t k) {
    state_[k].gap = state_[k].u = 0;
    state_[k].since = state_[k].last = now_;
    due_.remove(k);
    impacts_.remove(k);
  }

  /// v_k = -(u_0 + ... + u_k)
  std::vector<Real> velocities() const {
    std::vector<Real> v(contacts_);
    Real sum = 0;
    for (std::size_t k = 0; k < contacts_; ++k) v[k] = -(sum += state_[k].u);
    return v;
  }

  std::size_t contacts_;
  Real e_, e_wall_;
  HardSphereSettings settings_;
  StopLogic stop_;
  Real memory_ = 0;  ///< contact time of the TC model; 0: all collisions dissipate
  std::vector<Contact> state_;
  std::vector<Real> mass_;  ///< of the bead below contact k, and of the top bead; the first is the wall's; empty: all 1
  Real spread_;
  Tournament<Real> due_;      ///< times of the next collisions of approaching contacts
  Tournament<Real> impacts_;  ///< minus the closing speeds of touching contacts that approach
  Real now_ = 0, first_wall_ = -1, last_wall_ = 0;
  Real settled_below_ = 0;
  double touching_gap_;
  std::uint64_t next_look_ = 0, next_try_ = 0;
  std::vector<double> touching_;         ///< closing speeds of a run of touching contacts
  std::size_t lowest_ = 0;               ///< lowest contact of this run
  std::optional<HitMemory<Real>> hits_;  ///< only of runs that are done again
  Outcome<Real> outcome_;
};

}  // namespace sigmasweep
