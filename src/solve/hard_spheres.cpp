#include "sigmasweep/solve/hard_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "hard_spheres_cluster.hpp"
#include "in_si.hpp"
#include "samples.hpp"
#include "noise.hpp"
#include "sigmasweep/scene/calibration.hpp"
#include "tournament.hpp"

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A relative velocity that is this much smaller than the two it is the difference of is rounding: it is zero.
constexpr double cancelled = 1e-14;
/// A pair that collides again within this fraction of the time so far collides in next to no time.
constexpr double again = 1e-6;

/// The unit of length: the gap, if there is one.
double length_of(const Column<double>& column) { return column.gap > 0.0 ? column.gap : 1.0; }

/// How much faster than the heaviest bead the lightest one can be with the same energy.
double spread(const std::vector<double>& mass) {
  if (mass.empty()) return 1.0;
  const auto [lightest, heaviest] = std::minmax_element(mass.begin(), mass.end());
  return std::sqrt(*heaviest / *lightest);
}

/// Contacts are numbered k = 0 (the wall) to N-1; units are the speed, length_of() and the mean bead's mass. The state
/// is each contact's gap at its own time `since` and its closing speed u (> 0: approaching), so neither is a small
/// difference of large numbers.
class HardSphereColumn {
 public:
  HardSphereColumn(const Column<double>& column, const HardSphereOptions& options)
      : contacts_(static_cast<std::size_t>(column.N)), e_(column.eps), e_wall_(column.eps_wall), options_(options),
        state_(contacts_), spread_(spread(column.mass)), due_(contacts_), impacts_(contacts_) {
    const double N = static_cast<double>(column.N), length = length_of(column);
    if (options_.collision_limit == 0)
      options_.collision_limit = static_cast<std::uint64_t>(std::min(1e7 + 10.0 * N * N, 2e8));
    if (options_.rule == EdRule::tc) memory_ = column.gap > 0.0 ? column.tc * column.speed / length : infinity;
    for (std::size_t k = 0; k < contacts_; ++k) state_[k].gap = column.initial_gap(k) / length;
    state_[0].above = 1.0;
    if (!column.mass.empty()) take_masses(column.mass);
    settled_below_ = 2.0 * spread_ * std::sqrt(N * options_.settle);
    state_[0].u = 1.0;
    schedule(0);
  }

  /// Seen by a watcher, Nobody or Samples, with whose last sample it may end.
  template <class Watcher>
  Outcome<double> run(Watcher& watcher) {
    show(watcher, 0.0);
    while (outcome_.end == End::none) {
      if (outcome_.contacts >= options_.collision_limit) {
        outcome_.status = Status::event_limit;
        break;
      }
      if (options_.patience && options_.patience->is_over(1)) {
        outcome_.status = Status::time_limit;
        break;
      }
      if (const std::size_t k = impacts_.first(); impacts_.time_of(k) < 0.0)
        meet(k);
      else
        advance(watcher);
      if constexpr (Watcher::watches)
        if (watcher.done()) break;
    }
    outcome_.velocity = velocities();
    outcome_.t_k = last_wall_ - std::max(first_wall_, 0.0);
    return outcome_;
  }

 private:
  struct Contact {
    double gap = 0.0, u = 0.0, since = 0.0;
    double last = -infinity;  ///< time of the last collision
    double below = 0.5, above = 0.5;  ///< share of the lower and the upper bead in a change of u, by their masses
  };

  /// The present flights hold up to and at `time`.
  template <class Watcher>
  void show(Watcher& watcher, double time) const {
    if constexpr (Watcher::watches)
      watcher.until(time, [this](double t, auto x, auto u) {
        for (std::size_t k = 0; k < contacts_; ++k) {
          x[k] = -gap_at(k, t);
          u[k] = state_[k].u;
        }
      });
  }

  void take_masses(const std::vector<double>& mass) {
    mass_.assign(1, infinity);  // the wall
    mass_.insert(mass_.end(), mass.begin(), mass.end());
    for (std::size_t k = 0; k < contacts_; ++k) {
      state_[k].below = 1.0 / (1.0 + mass_[k] / mass_[k + 1]);
      state_[k].above = 1.0 / (1.0 + mass_[k + 1] / mass_[k]);
    }
  }

  std::span<const double> masses() const { return std::span(mass_).subspan(mass_.empty() ? 0 : 1); }

  /// To the next time at which anybody collides, and all who do become touching.
  template <class Watcher>
  void advance(Watcher& watcher) {
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

  bool same_as_now(double time) const { return time - now_ <= options_.same_time * now_; }

  /// Contact k, the next to collide, can change eps_eff by at least m_ij u^2/(4 M), m_ij = 2 m_i m_j/(m_i + m_j), M
  /// the mass of the column, so there is no need to look before that is small; and then not at every collision. A
  /// contact in a series of ever faster collisions is left to it.
  bool is_settled(std::size_t k) {
    const Contact& contact = state_[k];
    if (contact.u > settled_below_ || outcome_.contacts < next_look_) return false;
    if (is_again(contact, due_.time_of(k))) return false;
    next_look_ = outcome_.contacts + contacts_;
    return residual_dissipation<double>(velocities(), 1.0, masses()) < options_.settle;
  }

  static bool is_again(const Contact& contact, double time) { return time - contact.last <= again * time; }

  void touch(std::size_t k) {
    state_[k].gap = 0.0;
    state_[k].since = now_;
    due_.remove(k);
    impacts_.set(k, -state_[k].u);  // LRV: the fastest is first
  }

  /// The touching contact that approaches fastest: a collision, or the last of infinitely many.
  void meet(std::size_t k) {
    const Contact& contact = state_[k];
    const bool collapsed = contact.u < options_.collapsed_speed && is_again(contact, now_);
    const bool foresees = options_.foresee_collapse && mass_.empty();
    if (memory_ == 0.0 && (collapsed || (foresees && outcome_.contacts >= next_try_))) {
      find_touching(k);
      next_try_ = outcome_.contacts + 16 + touching_.size();
      const auto mass = mass_.empty() ? std::span<const double>() : std::span(mass_).subspan(lowest_);
      const Cluster cluster = cluster_around(k - lowest_, touching_, lowest_ == 0, mass);
      if (collapsed || will_collapse(cluster, e_)) return collapse(cluster);
    }
    collide(k);
  }

  /// The TC model: one of the two beads has collided, with the other one or its other neighbour, less than tc ago.
  /// Times that are the same count as such even where tc is too short for the clock; just tc is not less.
  bool is_elastic(std::size_t k) const {
    double last = state_[k].last;
    if (k > 0) last = std::max(last, state_[k - 1].last);
    if (k + 1 < contacts_) last = std::max(last, state_[k + 1].last);
    const double resolution = options_.same_time * now_;
    return now_ - last < std::max(memory_ - resolution, resolution);
  }

  /// u -> -e u. The beads share the change (1 + e) u by their masses; at the wall the bead takes all of it.
  void collide(std::size_t k) {
    Contact& contact = state_[k];
    const double u = contact.u, e = memory_ > 0.0 && is_elastic(k) ? 1.0 : k == 0 ? e_wall_ : e_;
    const double change = (1.0 + e) * u;
    contact.u = -e * u;
    contact.last = now_;
    impacts_.remove(k);
    if (k > 0) push(k - 1, contact.below * change);
    if (k + 1 < contacts_) push(k + 1, contact.above * change);
    ++outcome_.contacts;
    if (k > 0) return;
    if (first_wall_ < 0.0) first_wall_ = now_;
    last_wall_ = now_;
  }

  /// The neighbour of a collision closes faster by `change`.
  void push(std::size_t k, double change) {
    Contact& contact = state_[k];
    contact.gap = gap_now(k);
    contact.since = now_;
    const double u = contact.u + change;
    contact.u = std::fabs(u) <= cancelled * std::fabs(change) ? 0.0 : u;
    schedule(k);
  }

  double gap_now(std::size_t k) const { return gap_at(k, now_); }
  double gap_at(std::size_t k, double time) const {
    const Contact& contact = state_[k];
    return std::max(contact.gap - contact.u * (time - contact.since), 0.0);
  }

  void schedule(std::size_t k) {
    const Contact& contact = state_[k];
    if (!(contact.u > 0.0)) {
      due_.remove(k);
      impacts_.remove(k);
      return;
    }
    const double due = contact.since + contact.gap / contact.u;
    if (same_as_now(due)) {
      touch(k);
    } else {
      impacts_.remove(k);
      due_.set(k, due);
    }
  }

  void find_touching(std::size_t k) {
    // A contact that recedes faster than all others together can close it stays open.
    const double limit = spread_ * static_cast<double>(contacts_) * state_[k].u;
    const auto touches = [&](std::size_t j) {
      return gap_now(j) <= options_.same_time && std::fabs(state_[j].u) <= limit;
    };
    lowest_ = k;
    while (lowest_ > 0 && touches(lowest_ - 1)) --lowest_;
    touching_.clear();
    for (std::size_t j = lowest_; j <= k || (j < contacts_ && touches(j)); ++j) touching_.push_back(state_[j].u);
  }

  /// Infinitely many collisions, done at once.
  void collapse(const Cluster& cluster) {
    outcome_.status = Status::collapsed;
    const std::size_t first = lowest_ + cluster.first, end = first + cluster.beads - 1;
    for (std::size_t j = first; j < end; ++j) rest(j);
    if (first > 0) push(first - 1, -cluster.bottom_change);
    if (end < contacts_) push(end, cluster.top_change);
    if (cluster.wall) last_wall_ = now_;
    ++outcome_.contacts;
  }

  void rest(std::size_t k) {
    state_[k].gap = state_[k].u = 0.0;
    state_[k].since = state_[k].last = now_;
    due_.remove(k);
    impacts_.remove(k);
  }

  /// v_k = -(u_0 + ... + u_k)
  std::vector<double> velocities() const {
    std::vector<double> v(contacts_);
    double sum = 0.0;
    for (std::size_t k = 0; k < contacts_; ++k) v[k] = -(sum += state_[k].u);
    return v;
  }

  std::size_t contacts_;
  double e_, e_wall_;
  HardSphereOptions options_;
  double memory_ = 0.0;  ///< the TC model's contact time; 0: collisions always lose
  std::vector<Contact> state_;
  std::vector<double> mass_;  ///< below contact k, and the top one; the first is the wall. Empty where all are 1
  double spread_;
  Tournament<double> due_;      ///< approaching: when
  Tournament<double> impacts_;  ///< touching and approaching: minus how fast
  double now_ = 0.0, first_wall_ = -1.0, last_wall_ = 0.0;
  double settled_below_ = 0.0;
  std::uint64_t next_look_ = 0, next_try_ = 0;
  std::vector<double> touching_;  ///< closing speeds of a run of touching contacts ...
  std::size_t lowest_ = 0;        ///< ... the lowest of which is this one
  Outcome<double> outcome_;
};

}  // namespace

Outcome<double> hard_sphere_collision(const Column<double>& column, const HardSphereOptions& options) {
  Nobody nobody;
  Outcome<double> outcome = HardSphereColumn(column, options).run(nobody);
  for (double& v : outcome.velocity) v *= column.speed;
  outcome.t_k *= length_of(column) / column.speed;
  return outcome;
}

void watch_hard_spheres(const Column<double>& column, EdRule rule, Samples& samples) {
  HardSphereColumn(column, {.settle = 0.0, .rule = rule}).run(samples);  // to the last sample
}

namespace {

/// The change of eps_eff when eps, and with it the wall's, and what is not the same for all beads change in their last
/// bits; and when other collisions count as simultaneous, as in columns that come close to collapse, and escape.
double condition(Column<double> column, HardSphereOptions options, double eps_eff) {
  options.same_time *= 0.25;
  constexpr double bits = 16.0 * epsilon;
  const bool matched = column.eps_wall == column.eps;
  column.eps *= 1.0 - bits;
  column.eps_wall = matched ? column.eps : wall_restitution(column.eps);
  Noise noise;
  for (double& gap : column.gaps) gap *= 1.0 + bits * noise.next();
  for (double& mass : column.mass) mass *= 1.0 + bits * noise.next();
  const Outcome<double> twin = hard_sphere_collision(column, options);
  return std::fabs(eps_eff - energies<double>(twin.velocity, 1.0, column.mass).eps_eff);
}

}  // namespace

Collision simulate_hard_spheres(const Parameters& parameters, Patience* patience) {
  const HardSphereOptions options{
      .settle = 1e-3 * parameters.tolerance, .rule = parameters.ed_rule, .patience = patience};
  const Column<double> column = reduced_column<double>(parameters);
  const std::span<const double> mass = column.mass;
  Outcome<double> outcome = hard_sphere_collision(column, options);
  const bool given_up = outcome.status == Status::event_limit;
  if (given_up) outcome.status = Status::tolerance_missed;  // what is left to dissipate says by how much
  const Energies<double> e = energies<double>(outcome.velocity, 1.0, mass);
  const double collisions_per_bead = static_cast<double>(outcome.contacts) / static_cast<double>(parameters.N);
  const double rounding = epsilon * spread(column.mass) * (4.0 + collisions_per_bead);
  double error = rounding + residual_dissipation<double>(outcome.velocity, 1.0, mass);
  if (!given_up) error += condition(column, options, e.eps_eff);
  return with_error(in_si(outcome, parameters, mass), error, parameters.tolerance);
}

}  // namespace sigmasweep
