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

/// Hard spheres on a plate that vibrates under gravity, from collision to collision. Beads start at rest relative to
/// the plate, with the gaps of the column. Units are vibration_units() and the mean bead's mass. Contacts are numbered
/// 0 (the plate) to N-1. The state is the gap and the closing speed of each contact at its own time.
///
/// Gaps between beads in flight change uniformly. The lowest beads may rest on the plate, as touching beads that move
/// with it, until it falls faster than gravity. The contact above the resting beads (0 if none rests) is driven by
/// plate and gravity.
///
/// Bounces become shorter and shorter, infinitely many in finite time. A bead whose next bounces would all be over
/// within 1e-8 periods comes to rest on the plate. Beads that collapse in flight (column.hpp) remain touching.
class VibratedHardSpheres {
 public:
  struct Settings {
    EdRule rule = EdRule::lrv;
    double tc = 0.0;                          ///< contact time of EdRule::tc
    std::uint64_t period_limit = 20'000'000;  ///< largest number of collisions in a period
  };

  /// The solver's own limit is 2e10 collisions.
  VibratedHardSpheres(const Column<double>& column, const Plate& plate, const Settings& settings,
                      const RunLimits& limits = {});

  /// Runs until the observer is done (see VibrationStatistics), or until status() has a reason to stop.
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
    double fastest = 0.0;             ///< largest speed in a series of collisions almost at the same time
    double mass = 1.0;                ///< mass of the bead above
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
  double heaviest_speed_;       ///< ratio of the speeds of the lightest and the heaviest bead with the same energy
  Tournament<double> due_;      ///< times of the next collisions of approaching contacts
  Tournament<double> impacts_;  ///< minus the closing speeds of touching contacts that approach
  double now_ = 0.0, load_, plate_speed_;  ///< at the present time
  std::size_t resting_ = 0;                ///< number of beads that rest on the plate, and index of the driven contact
  bool aimless_ = true;                    ///< the time of the driven contact's collision is not known yet
  double take_off_ = infinity;             ///< time at which the resting beads leave the plate
  double booked_ = 0.0;                    ///< energy_with_plate() of the resting beads when their work was last added
  double resting_mass_ = 0.0;
  double start_energy_ = 0.0;
  double in_ = 0.0, dissipated_ = 0.0;          ///< the plate's work and the dissipation in this period
  double all_in_ = 0.0, all_dissipated_ = 0.0;  ///< the same in earlier periods, apart to keep small terms exact
  Status status_ = Status::ok;
  std::uint64_t collisions_ = 0, period_began_ = 0, next_try_ = 0;
  std::vector<double> touching_;  ///< closing speeds of a run of touching contacts
};

/// Computes a vibrated column of hard spheres: SimulationResult::vibration, contacts, end and status. The status is
/// collapsed if beads collapse or come to rest on the plate. With EdRule::tc beads do not come to rest, but bounce for
/// about tc, so that a period has about 1/(f tc) collisions for each bead. The status is event_limit after 2e7
/// collisions in one period, as of elastic beads that the plate hardly lifts.
SimulationResult simulate_vibrated_hard_spheres(const Parameters& parameters, ComputeBudget* budget = nullptr);
/// Computes a vibrated column until the last sample is taken. Samples are in vibration_units(), relative to the plate.
void observe_vibrated_hard_spheres(const Parameters& parameters, VibratedSamples& samples);

}  // namespace sigmasweep
