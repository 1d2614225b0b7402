#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/contact_state.hpp"
#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// The fixed wall of a column without gravity.
struct FixedWall {
  static constexpr bool moves = false;
};

/// Units of a solver for a vibrated column or lattice, in SI.
struct VibrationUnits {
  double time, length;  ///< s, m
  double speed() const { return length / time; }
};

/// Units of soft spheres are tc and v0 tc, as in a collision. Units of hard spheres are 1/omega and g/omega^2, in which
/// alpha is the only parameter of the plate.
inline VibrationUnits vibration_units(const Parameters& p) {
  const double omega = 2.0 * std::numbers::pi * p.frequency;
  if (p.method == Method::ed) return {1.0 / omega, p.gravity / (omega * omega)};
  return {p.tc, p.v0 * p.tc};
}

/// A plate that vibrates as z0(t) = A0 sin(omega t), Eq. (1), under gravity g, in any consistent units. Gravity and the
/// plate's acceleration act on the contact of the lowest bead alone, whose overlap x = z0 - h_1 + d/2 obeys
///     x'' = load(t) + contact forces,  load(t) = g + z0''(t) = g - A0 omega^2 sin(omega t).
/// They do not act on contacts between beads, which fall alike.
struct Plate {
  static constexpr bool moves = true;
  double g = 0.0, A0 = 0.0, omega = 0.0;

  double period() const { return 2.0 * std::numbers::pi / omega; }
  /// A0 omega^2/g
  double alpha() const { return A0 * omega * omega / g; }
  double height(double t) const { return A0 * std::sin(omega * t); }
  double speed(double t) const { return A0 * omega * std::cos(omega * t); }
  double load(double t) const { return g - A0 * omega * omega * std::sin(omega * t); }

  static Plate of(const Parameters& p, const VibrationUnits& units) {
    if (p.method == Method::ed) return {1.0, p.alpha, 1.0};
    return {p.gravity * units.time / units.speed(), p.A0 / units.length,
            2.0 * std::numbers::pi * p.frequency * units.time};
  }

  /// The contact at time `elapsed` after the state `entry` at time t, if nothing touches the bead meanwhile. It is
  /// computed without differences of sines at nearby times, so that an overlap of 1e-12 keeps its digits.
  ContactState<double> flight(const ContactState<double>& entry, double t, double elapsed) const;

  /// Duration of a flight from `entry` (x <= 0) at time t until the overlap rises through 0. Gravity ends every flight.
  /// The load changes its sign at known times. Between two of them the overlap is convex or concave and rises through 0
  /// at most once, so that Newton's method from the right side cannot miss it. A touching contact that is not driven
  /// apart lands at once.
  double landing(ContactState<double> entry, double t) const;

  /// Whether beads that rest on the plate at t stay there just afterwards.
  bool holds(double t) const { return !piece_from(t, 0.0).concave; }

  /// The first time from t on at which resting beads leave the plate; infinite if its acceleration never exceeds g.
  double take_off(double t) const;

 private:
  struct Piece {
    double end;    ///< time after t
    bool concave;  ///< load < 0
  };
  Piece piece_from(double t, double from) const;
  double certain_flight(const ContactState<double>& now, double t) const;
  double highest(const ContactState<double>& entry, double t, double low, double high) const;
  double root(const ContactState<double>& entry, double t, double low, double high, double guess) const;
};

/// Height of the plate of complete parameters in SI, A0 sin(2 pi f t), Eq. (1), m; t in s.
double plate_height(const Parameters& parameters, double t);
/// Speed of the plate, m/s; t in s.
double plate_speed(const Parameters& parameters, double t);

/// The plate's work int F_0 z0' dt, and the energy that the contacts dissipated.
struct PlateWork {
  double in = 0.0, lost = 0.0;
  PlateWork& operator+=(const PlateWork& other) {
    in += other.in;
    lost += other.lost;
    return *this;
  }
};

}  // namespace sigmasweep
