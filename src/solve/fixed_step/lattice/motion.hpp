#pragma once

#include <cstddef>

#include "assembly/lattice.hpp"
#include "solve/fixed_step/aligned_lanes.hpp"

namespace sigmasweep {

/// The lattice's equation of motion: two components per bead, x and z, whose accelerations the contacts give. Ground:
/// in a container that moves as a plate does, and seen from it, all beads feel the load too.
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

}  // namespace sigmasweep
