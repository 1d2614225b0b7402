#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "assembly/lattice.hpp"
#include "solve/fixed_step/between_steps.hpp"
#include "solve/fixed_step/driver.hpp"
#include "solve/fixed_step/lattice/contacts.hpp"
#include "solve/fixed_step/lattice/motion.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// A lattice that a scheme steps, with its contacts and the neighbour lists that they come from: a System of
/// FixedStepDriver.
template <class Force, bool Uneven, class Scheme, class Ground>
class LatticeSystem {
 public:
  using Contacts = LatticeContacts<Force, Uneven, Ground::moves>;
  using Motion = LatticeMotion<Contacts, Ground>;
  using Stepper = typename Scheme::template Stepper<Motion>;
  using Outcome = LatticeOutcome<double>;

  LatticeSystem(const Lattice<double>& lattice, double dt, const Ground& ground)
      : lattice_(lattice),
        dt_(dt),
        neighbours_(lattice),
        contacts_(lattice, dt),
        motion_(lattice, dt, ground, contacts_),
        scheme_(listed()) {}
  LatticeSystem(const LatticeSystem&) = delete;

  double dt() const { return dt_; }
  std::size_t beads() const { return lattice_.count(); }
  std::size_t contact_count() const { return contacts_.size(); }
  const Contacts& contacts() const { return contacts_; }
  Stepper& scheme() { return scheme_; }
  const Stepper& scheme() const { return scheme_; }
  void set_time(double steps) requires(Ground::moves) { motion_.set_time(steps); }
  Vec2<double> q(std::size_t i) const { return {scheme_.x()[2 * i], scheme_.x()[2 * i + 1]}; }
  /// Velocity of bead i, lengths a step.
  Vec2<double> u(std::size_t i) const { return {scheme_.u()[2 * i], scheme_.u()[2 * i + 1]}; }

  template <class Touch>
  ContactChanges look(Touch&& touch) {
    return contacts_.look(touch);
  }
  /// Makes the lists anew before a contact can close that is on none of them.
  void after_step() {
    const double most = trigger * neighbours_.leeway();
    double furthest = 0.0;
    for (std::size_t i = 0; i < beads(); ++i) {
      const Vec2<double> gone = q(i) - neighbours_.anchor(i);
      furthest = std::max(furthest, dot(gone, gone));
    }
    if (furthest > most * most) make_lists();
  }
  void after_coast() { after_step(); }
  /// Number of steps that all beads can go on before the lists must be made anew.
  double steps_within_lists() const {
    double steps = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < beads(); ++i) {
      const Vec2<double> gone = q(i) - neighbours_.anchor(i), speed = u(i);
      const double left = neighbours_.leeway() - std::sqrt(dot(gone, gone)), squared = dot(speed, speed);
      if (squared > 0.0) steps = std::min(steps, left / std::sqrt(squared));
    }
    return steps;
  }

  /// 1/2 m v^2 and springs, in the units of a step.
  double energy() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < beads(); ++i) sum += lattice_.mass(i) * dot(u(i), u(i));
    return 0.5 * (sum + contacts_.elastic());
  }

  /// Keeps the state before the next steps.
  void remember() {
    const std::size_t components = motion_.components();
    q_before_.assign(scheme_.x(), scheme_.x() + components);
    u_before_.assign(scheme_.u(), scheme_.u() + components);
  }
  /// Displacements and velocities within the `steps` since remember(), `s` from 0 to 1 on the way.
  void between(double s, double steps, std::span<Vec2<double>> at, std::span<Vec2<double>> v) const {
    const auto component = [&](std::size_t k) {
      return BetweenSteps(s, steps, q_before_[k], u_before_[k], scheme_.x()[k], scheme_.u()[k]);
    };
    for (std::size_t i = 0; i < beads(); ++i) {
      const BetweenSteps x = component(2 * i), z = component(2 * i + 1);
      at[i] = {x.x, z.x};
      v[i] = {x.u / dt_, z.u / dt_};
    }
  }

  /// Free flight, `steps` from now.
  void extrapolate(double steps, std::span<Vec2<double>> at, std::span<Vec2<double>> v) const {
    for (std::size_t i = 0; i < beads(); ++i) {
      at[i] = q(i) + steps * u(i);
      v[i] = 1.0 / dt_ * u(i);
    }
  }

  /// Power that the dashpots take, time in steps.
  double power_lost() const requires(Ground::moves) { return contacts_.lost(); }
  /// Power of the container at a time in steps, time in steps.
  double power_in(const Ground& plate, double now) const requires(Ground::moves) {
    return contacts_.lift() * plate.speed(now * dt_) * dt_;
  }
  /// Works are divided by this to have the solver's units.
  double work_unit() const { return dt_ * dt_; }
  double weight(const Ground& plate) const requires(Ground::moves) {
    double sum = 0.0;
    for (std::size_t i = 0; i < beads(); ++i) sum += plate.g * lattice_.mass(i);
    return sum;
  }
  /// Energy at the beginning of a period: kinetic in the room's frame, of gravity (0 for beads on their sites) and
  /// elastic.
  double energy_on(const Ground& plate) const requires(Ground::moves) {
    double sum = 0.5 * contacts_.elastic() / (dt_ * dt_);
    for (std::size_t i = 0; i < beads(); ++i) {
      const Vec2<double> v = 1.0 / dt_ * u(i) + Vec2<double>{0.0, plate.speed(0.0)};
      sum += lattice_.mass(i) * (0.5 * dot(v, v) + plate.g * q(i).z);
    }
    return sum;
  }

  void fill(Outcome& outcome) const {
    for (std::size_t i = 0; i < beads(); ++i) outcome.velocity.push_back(1.0 / dt_ * u(i));
    outcome.x_max = contacts_.deepest();
  }

 private:
  static constexpr double trigger = 0.9;  // the rest is for the step that goes further

  const Motion& listed() {
    contacts_.list(neighbours_, motion_.x.data(), motion_.u.data());
    return motion_;
  }
  /// Others that are on their way are taken along.
  void make_lists() {
    const double far = 0.5 * neighbours_.leeway();
    for (std::size_t i = 0; i < beads(); ++i) {
      const Vec2<double> gone = q(i) - neighbours_.anchor(i);
      if (dot(gone, gone) > far * far) neighbours_.move(i, q(i));
    }
    contacts_.list(neighbours_, scheme_.x(), scheme_.u());
  }

  const Lattice<double>& lattice_;
  double dt_;
  LatticeNeighbours<double> neighbours_;
  Contacts contacts_;
  Motion motion_;
  Stepper scheme_;
  std::vector<double> q_before_, u_before_;
};

}  // namespace sigmasweep
