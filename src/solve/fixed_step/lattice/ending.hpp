#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "assembly/lattice.hpp"
#include "solve/fixed_step/driver.hpp"

namespace sigmasweep {

/// When a lattice's collision is over. With gaps: when nothing has touched for Lattice::quiet_time(). Without: when
/// nothing approaches, or later contacts can change eps_eff by less than `settle`.
class LatticeEnding {
 public:
  static constexpr std::uint64_t steps_between_outlooks = 64;
  static constexpr std::uint64_t max_work = 10'000'000'000;  ///< steps times beads: some minutes
  static std::uint64_t event_limit(std::size_t beads) { return 100'000 + 1'000 * beads; }

  LatticeEnding(const Lattice<double>& lattice, double dt, double settle)
      : settle_(settle), quiet_(lattice.quiet_time() / dt) {}

  void note(double now, bool any_closed) {
    if (any_closed) last_closed_ = now;
  }
  Verdict quiet(double now) const {
    return {.end = quiet_ > 0.0 && now - last_closed_ >= quiet_ ? End::quiet : End::none};
  }
  /// Beads that creep and stick for good end by the energy that they have left.
  Verdict by_energy(double energy, double start_energy) const {
    const double all = std::sqrt(energy / start_energy);
    if (!(all < settle_)) return {};
    return {.end = End::settled, .remainder = all};
  }

  template <class System>
  Verdict look_ahead(const System& system, double now, double start_energy) {
    const Prospect p = prospect(system);
    if (quiet_ == 0.0) return over(p, per_energy(system, start_energy));
    if (const double held = p.held * per_energy(system, start_energy); held >= settle_) {
      last_lively_ = now;
    } else if (p.closed && now - last_lively_ >= quiet_) {
      return {.end = End::settled, .remainder = held};  // overdamped beads that stick for good are quiet, too
    }
    return {};
  }

  template <class System>
  FreeFlightAhead free_flight(const System& system, double now, double start_energy) const {
    const Prospect p = prospect(system);
    if (p.closed) return {};
    FreeFlightAhead flight{.steps = std::min(p.steps, system.steps_within_lists()), .verdict = {}};
    if (quiet_ > 0.0)
      flight.steps = std::min(flight.steps, last_closed_ + quiet_ - now);
    else
      flight.verdict = over(p, per_energy(system, start_energy));
    return flight;
  }

 private:
  /// What the contacts on the lists can do: for how many steps none of them closes, as distances are convex functions
  /// of time; the energy of closed and of approaching contacts, and how much of it they can lose. Units of a step.
  struct Prospect {
    bool closed = false, approaches = false;
    double steps = std::numeric_limits<double>::infinity();
    double held = 0.0, approaching = 0.0, loss = 0.0;
  };
  template <class System>
  static Prospect prospect(const System& system) {
    Prospect p;
    system.contacts().each(system.scheme().x(), system.scheme().u(),
                           [&](double overlap, double rate, double speed, double elastic, double inertia, double eps) {
                             if (overlap > 0.0) {
                               p.closed = true;
                               p.held += 0.5 * (elastic + speed * speed / inertia);
                               p.loss += 0.5 * (elastic + speed * speed / inertia);
                             } else if (rate > 0.0) {
                               p.approaches = true;
                               p.steps = std::min(p.steps, -overlap / rate);
                               p.approaching += 0.5 * rate * rate / inertia;
                               p.loss += 0.5 * rate * rate / inertia * (1.0 - eps * eps);
                             }
                           });
    return p;
  }

  /// d eps_eff/dE = 1/(2 eps_eff E0), as eps_eff^2 = E/E0.
  template <class System>
  static double per_energy(const System& system, double start_energy) {
    return 0.5 / std::sqrt(system.energy() * start_energy);
  }

  /// Without gaps.
  Verdict over(const Prospect& p, double per_energy) const {
    if (!p.closed && !p.approaches) return {.end = End::separated};
    if (!((p.held + p.approaching) * per_energy < settle_)) return {};  // elastic beads come apart, too
    return {.end = End::settled, .remainder = p.loss * per_energy};
  }

  double settle_;
  double quiet_;  ///< steps without a contact after which it is over; 0: without gaps
  double last_closed_ = 0.0, last_lively_ = 0.0;
};

}  // namespace sigmasweep
