#include "sigmasweep/solve/hard_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hard_spheres_cluster.hpp"
#include "in_si.hpp"
#include "sigmasweep/scene/calibration.hpp"
#include "tournament.hpp"

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Times closer than this, relative, are the same time: equal gaps and matched restitutions make exactly simultaneous
/// collisions, which rounding pulls apart by about 1e-16 a collision of the bead.
constexpr double same_time = 1e-12;
/// A relative velocity that is this much smaller than the two it is the difference of is rounding: it is zero.
constexpr double cancelled = 1e-14;
/// A pair that collides again within the fraction `again` of the time so far, and by now is slower than this (units
/// v0), will do so for ever: inelastic collapse.
constexpr double collapsed_speed = 1e-16;
constexpr double again = 1e-6;

/// Contacts are numbered k = 0 (the wall) to N-1; units are the speed and, if there is one, the gap. The state is each
/// contact's gap at its own time `since` and its closing speed u (> 0: approaching), so neither is a small difference
/// of large numbers.
class HardSphereColumn {
 public:
  HardSphereColumn(const Column<double>& column, const HardSphereOptions& options)
      : contacts_(static_cast<std::size_t>(column.N)), e_(column.eps), e_wall_(column.eps_wall), options_(options),
        state_(contacts_), due_(contacts_), impacts_(contacts_) {
    const double N = static_cast<double>(column.N);
    if (options_.collision_limit == 0)
      options_.collision_limit = static_cast<std::uint64_t>(std::min(1e7 + 10.0 * N * N, 2e8));
    settled_below_ = 2.0 * std::sqrt(N * options_.settle);
    for (Contact& contact : state_) contact.gap = column.gap > 0.0 ? 1.0 : 0.0;
    state_[0].u = 1.0;
    schedule(0);
  }

  Outcome<double> run() {
    while (outcome_.end == End::none) {
      if (outcome_.contacts >= options_.collision_limit) {
        outcome_.status = Status::event_limit;
        break;
      }
      if (const std::size_t k = impacts_.first(); impacts_.time_of(k) < 0.0)
        meet(k);
      else
        advance();
    }
    outcome_.velocity = velocities();
    outcome_.t_k = last_wall_ - std::max(first_wall_, 0.0);
    return outcome_;
  }

 private:
  struct Contact {
    double gap = 0.0, u = 0.0, since = 0.0;
    double last = -infinity;  ///< time of the last collision
  };

  /// To the next time at which anybody collides, and all who do become touching.
  void advance() {
    std::size_t k = due_.first();
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

  bool same_as_now(double time) const { return time - now_ <= same_time * now_; }

  /// Contact k, the next to collide, can change eps_eff by at least u^2/(4 N), so there is no need to look before that
  /// is small; and then not at every collision. A contact in a series of ever faster collisions is left to it.
  bool is_settled(std::size_t k) {
    const Contact& contact = state_[k];
    if (contact.u > settled_below_ || outcome_.contacts < next_look_) return false;
    if (is_again(contact, due_.time_of(k))) return false;
    next_look_ = outcome_.contacts + contacts_;
    return residual_dissipation<double>(velocities(), 1.0) < options_.settle;
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
    const bool collapsed = contact.u < collapsed_speed && is_again(contact, now_);
    if (collapsed || (options_.foresee_collapse && outcome_.contacts >= next_try_)) {
      find_touching(k);
      next_try_ = outcome_.contacts + 16 + touching_.size();
      const Cluster cluster = cluster_around(k - lowest_, touching_, lowest_ == 0);
      if (collapsed || will_collapse(cluster, e_)) return collapse(cluster);
    }
    collide(k);
  }

  /// u -> -e u. Beads of equal mass share the change (1 + e) u; at the wall the bead takes all of it.
  void collide(std::size_t k) {
    Contact& contact = state_[k];
    const double u = contact.u, e = k == 0 ? e_wall_ : e_;
    const double change = k == 0 ? (1.0 + e) * u : 0.5 * (1.0 + e) * u;
    contact.u = -e * u;
    contact.last = now_;
    impacts_.remove(k);
    if (k > 0) push(k - 1, change);
    if (k + 1 < contacts_) push(k + 1, change);
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

  double gap_now(std::size_t k) const {
    const Contact& contact = state_[k];
    return std::max(contact.gap - contact.u * (now_ - contact.since), 0.0);
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
    const double limit = static_cast<double>(contacts_) * state_[k].u;
    const auto touches = [&](std::size_t j) { return gap_now(j) <= same_time && std::fabs(state_[j].u) <= limit; };
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
    state_[k] = {.gap = 0.0, .u = 0.0, .since = now_, .last = now_};
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
  std::vector<Contact> state_;
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
  Outcome<double> outcome = HardSphereColumn(column, options).run();
  for (double& v : outcome.velocity) v *= column.speed;
  outcome.t_k *= column.gap / column.speed;
  return outcome;
}

namespace {

/// The change of eps_eff when eps, and with it the wall's, changes in its last bits.
double condition(Column<double> column, const HardSphereOptions& options, double eps_eff) {
  const bool matched = column.eps_wall == column.eps;
  column.eps *= 1.0 - 16.0 * epsilon;
  column.eps_wall = matched ? column.eps : wall_restitution(column.eps);
  const Outcome<double> twin = hard_sphere_collision(column, options);
  return std::fabs(eps_eff - energies<double>(twin.velocity, 1.0).eps_eff);
}

}  // namespace

Collision simulate_hard_spheres(const Parameters& parameters) {
  const HardSphereOptions options{.settle = 1e-3 * parameters.tolerance};
  const Column<double> column = reduced_column<double>(parameters);
  Outcome<double> outcome = hard_sphere_collision(column, options);
  const bool given_up = outcome.status == Status::event_limit;
  if (given_up) outcome.status = Status::tolerance_missed;  // what is left to dissipate says by how much
  const Energies<double> e = energies<double>(outcome.velocity, 1.0);
  const double collisions_per_bead = static_cast<double>(outcome.contacts) / static_cast<double>(parameters.N);
  double error = epsilon * (4.0 + collisions_per_bead) + residual_dissipation<double>(outcome.velocity, 1.0);
  if (!given_up) error += condition(column, options, e.eps_eff);
  return with_error(in_si(outcome, parameters), error, parameters.tolerance);
}

}  // namespace sigmasweep
