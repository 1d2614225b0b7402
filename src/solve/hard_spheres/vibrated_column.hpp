#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "contact/contact_state.hpp"
#include "numerics/tournament.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/hard_spheres/cluster.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {

class VibratedSamples;

/// Hard spheres on a plate that vibrates under gravity, from collision to collision; the beads start at rest relative
/// to the plate, all gaps as in the column. Lengths and times are the plate's, masses are over the mean bead's,
/// contacts are numbered 0 (the plate) to N-1. The state is each contact's gap and closing speed at its own time.
///
/// Gaps between beads in flight change uniformly. The lowest beads may rest on the plate, as touching beads that move
/// with it, until it falls away faster than gravity; the contact above them, 0 if none rests, is the one that the plate
/// and gravity drive.
///
/// Bounces get ever shorter, infinitely many in finite time. Beads whose next bounces would all be over within 1e-8
/// periods are at rest on the plate from now on, and those that collapse in flight (column.hpp) go on as
/// touching beads.
class VibratedHardSpheres {
 public:
  struct Settings {
    EdRule rule = EdRule::lrv;
    double tc = 0.0;                          ///< of EdRule::tc
    std::uint64_t period_limit = 20'000'000;  ///< collisions in a period before giving up
  };

  /// Limit of its own: 2e10 collisions.
  VibratedHardSpheres(const Column<double>& column, const Plate& plate, const Settings& settings,
                      const RunLimits& limits = {});

  /// Until the watcher has seen enough (vibration_statistics.hpp says what one is), or status() says why not.
  template <class Watcher>
  void run(Watcher& watcher) {
    while (!watcher.done() && !gives_up()) {
      if (const std::size_t k = impacts_.first(); impacts_.time_of(k) < 0.0) {
        meet(k);
        continue;
      }
      settle();
      if (impacts_.time_of(impacts_.first()) < 0.0) continue;
      const double next = std::min({due_.time_of(due_.first()), take_off_, period_});
      watcher.until(next, [this](double t, auto x, auto u) {
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
          const State state = at(k, t);
          x[k] = state.x;
          u[k] = state.u;
        }
      });
      advance(next);
      if (next == period_) {
        begin_period();
        watcher.end_period(energy() - start_energy_, all_in_, all_dissipated_);
      }
    }
  }

  Status status() const { return status_; }
  std::uint64_t collisions() const { return collisions_; }

 private:
  using State = ContactState<double>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Contact {
    double gap = 0.0, u = 0.0, since = 0.0;
    double last = -infinity;          ///< time of the last collision
    double fastest = 0.0;             ///< of the collisions that have followed on each other in next to no time
    double mass = 1.0;                ///< of the bead above
    double below = 0.0, above = 1.0;  ///< share of the lower and the upper bead in a change of u, by their masses
  };

  bool gives_up();
  void advance(double time);
  void begin_period();
  double energy() const;

  State at(std::size_t k, double t) const {
    const Contact& contact = contacts_[k];
    State state{-contact.gap + contact.u * (t - contact.since), contact.u};
    if (k == resting_) state = plate_.flight({-contact.gap, contact.u}, contact.since, t - contact.since);
    return {std::min(state.x, 0.0), state.u};
  }
  void update(std::size_t k);
  void touch(std::size_t k);
  void schedule(std::size_t k);
  void change_rate(std::size_t k, double change);

  void meet(std::size_t k);
  void collide(std::size_t k);
  bool is_again(std::size_t k) const;
  bool is_elastic(std::size_t k) const;

  bool comes_to_rest(std::size_t k);
  bool collapses(std::size_t k);
  void join(std::size_t lowest, const Cluster& cluster);
  std::size_t find_touching(std::size_t k);
  std::vector<double> masses_from(std::size_t contact) const;

  void settle();
  bool rests(std::size_t k) const;
  void let_rest(std::size_t beads);
  double energy_with_plate(double t) const;

  Plate plate_;
  Settings settings_;
  StopLogic stop_;
  double period_, e_, e_wall_;
  bool equal_masses_;
  std::vector<Contact> contacts_;
  double heaviest_speed_;       ///< how much faster than the heaviest bead the lightest one can be with the same energy
  Tournament<double> due_;      ///< approaching: when
  Tournament<double> impacts_;  ///< touching and approaching: minus how fast
  double now_ = 0.0, load_, plate_speed_;  ///< now
  std::size_t resting_ = 0;                ///< beads that rest on the plate; the number of the driven contact
  bool aimless_ = true;                    ///< when the driven contact is due is not known yet
  double take_off_ = infinity;             ///< when those that rest will leave the plate
  double booked_ = 0.0;                    ///< what those had of energy_with_plate() when their work was last entered
  double resting_mass_ = 0.0;
  double start_energy_ = 0.0;
  double in_ = 0.0, dissipated_ = 0.0;          ///< the plate's work and what collisions lost in this period ...
  double all_in_ = 0.0, all_dissipated_ = 0.0;  ///< ... and before: small terms would vanish beside these sums
  Status status_ = Status::ok;
  std::uint64_t collisions_ = 0, period_began_ = 0, next_try_ = 0;
  std::vector<double> touching_;  ///< closing speeds of a run of touching contacts
};

/// The run of a vibrated column of hard spheres: SimulationResult::vibration, contacts, end and status. A column that
/// collapses is Status::collapsed, and so is one whose beads come to rest on the plate. With EdRule::tc there is no
/// such end of bouncing: a bead goes on in hops of about tc, so that a period takes some 1/(f tc) collisions a bead.
/// Status::event_limit after 2e7 collisions in one period, as of elastic beads that the plate only just lifts.
SimulationResult simulate_vibrated_hard_spheres(const Parameters& parameters, ComputeBudget* budget = nullptr);
/// The same seen by the samples, in vibration_units(), relative to the plate; over with the last sample.
void observe_vibrated_hard_spheres(const Parameters& parameters, VibratedSamples& samples);

}  // namespace sigmasweep
