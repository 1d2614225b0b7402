#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "assembly/ground.hpp"
#include "solve/fixed_step/column/chain.hpp"
#include "solve/fixed_step/dispatch.hpp"
#include "solve/fixed_step/lattice/contacts.hpp"

namespace sigmasweep {

/// The lattice's equation of motion for the schemes of fixed step, which know it as a Chain: two components a bead, of
/// which the accelerations are what the contacts say. Ground: in a container that moves as a plate does, and seen from
/// it, all beads feel the load too.
template <class Contacts, class Ground>
class LatticeMotion {
 public:
  static constexpr bool driven = Ground::moves;
  static constexpr bool one_by_one = false;

  LatticeMotion(const Lattice<double>& lattice, double dt, const Ground& ground, Contacts& contacts)
      : x(2 * lattice.count()),
        u(2 * lattice.count()),
        speed(lattice.beads.speed * dt),
        contacts_(contacts),
        components_(2 * lattice.count()),
        dt_(dt),
        ground_(ground) {
    for (std::size_t i = 0; i < lattice.count(); ++i) {
      if (!lattice.shift.empty()) {
        x[2 * i] = lattice.shift[i].x;
        x[2 * i + 1] = lattice.shift[i].z;
      }
      if constexpr (!driven) u[2 * i + 1] = -speed;
    }
  }

  void set_time(double steps) requires driven { now_ = steps; }

  void forces(const double* q, const double* v, double* a) const { contacts_.accelerations(q, v, a); }
  void drive(double* a, double ahead) const {
    if constexpr (driven) {
      const double load = ground_.load((now_ + ahead) * dt_) * dt_ * dt_;
      for (std::size_t k = 1; k < components_; k += 2) a[k] -= load;
    }
  }
  AlignedLanes first_acceleration() const requires driven {
    AlignedLanes a(components_);
    forces(x.data(), u.data(), a.data());
    drive(a.data(), 0.0);
    return a;
  }

  struct Coupling {
    Coupling view() const { return *this; }
    double acceleration(const double* a, std::size_t k) const { return a[k]; }
  };
  Coupling coupling;
  std::nullptr_t contact() const { return nullptr; }
  std::size_t components() const { return components_; }
  std::size_t lanes() const { return AlignedLanes::padded(components_); }

  AlignedLanes x, u;  ///< displacements and velocities at the start
  double speed;

 private:
  Contacts& contacts_;
  std::size_t components_;
  double dt_, now_ = 0.0;
  Ground ground_;
};

/// A lattice that a scheme steps, with its contacts and the lists that they come from.
template <class Force, bool Uneven, template <class> class Scheme, class Ground>
class LatticeSteps {
 public:
  using Contacts = LatticeContacts<Force, Uneven, Ground::moves>;
  using Motion = LatticeMotion<Contacts, Ground>;

  LatticeSteps(const Lattice<double>& lattice, double dt, const Ground& ground = {})
      : lattice_(lattice),
        dt_(dt),
        neighbours_(lattice),
        contacts_(lattice, dt),
        motion_(lattice, dt, ground, contacts_),
        scheme_(listed()) {}
  LatticeSteps(const LatticeSteps&) = delete;

  Motion& motion() { return motion_; }
  Contacts& contacts() { return contacts_; }
  const Contacts& contacts() const { return contacts_; }
  Scheme<Motion>& scheme() { return scheme_; }
  std::size_t beads() const { return lattice_.count(); }
  Vec2<double> q(std::size_t i) const { return {scheme_.x()[2 * i], scheme_.x()[2 * i + 1]}; }
  /// In lengths a step.
  Vec2<double> u(std::size_t i) const { return {scheme_.u()[2 * i], scheme_.u()[2 * i + 1]}; }

  /// Before a contact can close that is on no list: to be called after each step.
  void keep_lists() {
    const double most = trigger * neighbours_.leeway();
    double furthest = 0.0;
    for (std::size_t i = 0; i < beads(); ++i) {
      const Vec2<double> gone = q(i) - neighbours_.anchor(i);
      furthest = std::max(furthest, dot(gone, gone));
    }
    if (furthest > most * most) make_lists();
  }
  /// Steps that all beads can go on before lists must be made anew.
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

  /// For the watcher: what the beads were like before the next steps.
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
  Scheme<Motion> scheme_;
  std::vector<double> q_before_, u_before_;
};

}  // namespace sigmasweep
