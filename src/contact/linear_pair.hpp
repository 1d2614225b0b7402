#pragma once

#include <cmath>

#include "contact/contact_state.hpp"

namespace sigmasweep {

/// A contact whose two partners (or bead and wall) touch nothing else: x'' + 2 mu x' + omega0^2 x = 0, Eq. (5), solved
/// in closed form from any phase. `inertia` is 1/m_red in the column's units: 2 for a pair of equal beads, 1 at the
/// wall.
template <class Real>
class BinaryContact {
 public:
  /// The law of a contact with spring K and dashpot C (both over the mean bead's mass).
  BinaryContact(Real K, Real C, Real inertia) : inertia_(inertia), mu_(inertia * C / 2), omega0_2_(inertia * K) {
    using std::exp, std::sqrt, std::atan2;
    const Real omega_2 = omega0_2_ - mu_ * mu_;
    oscillates_ = omega_2 > Real(least_omega_2) * omega0_2_;
    if (!oscillates_) return;
    omega_ = sqrt(omega_2);
    duration_ = pi() / omega_;
    restitution_ = exp(-mu_ * duration_);
    const Real deepest_at = atan2(omega_, mu_) / omega_;
    deepest_ = exp(-mu_ * deepest_at) / sqrt(omega0_2_);
  }

  using State = ContactState<Real>;

  /// Over- and critically damped contacts never come back to x = 0 from a fresh start: not for this formula. Nor are
  /// those close to it, as 1/omega would raise its rounding errors: restitutions below 1e-13.
  bool oscillates() const { return oscillates_; }

  /// Time until x returns to 0 from (x >= 0, u); u > 0 if x = 0.
  Real time_left(const State& start) const {
    using std::atan2;
    if (start.x == Real(0)) return duration_;
    const Real phase = atan2(omega_ * start.x, start.u + mu_ * start.x);
    return (pi() - phase) / omega_;
  }

  /// The linear map that takes (x, u) to (x, u) a given time later.
  struct Map {
    Real xx, xu, ux, uu;
    State operator()(const State& s) const { return {xx * s.x + xu * s.u, ux * s.x + uu * s.u}; }
  };
  Map after(const Real& t) const {
    using std::cos, std::exp, std::sin;
    const Real decay = exp(-mu_ * t), s = decay * sin(omega_ * t), c = decay * cos(omega_ * t);
    const Real r = mu_ / omega_ * s;
    return {c + r, s / omega_, -omega0_2_ / omega_ * s, c - r};
  }
  /// The map over time_left(start); a fresh start (x = 0) needs no functions.
  Map until_end(const State& start) const {
    if (start.x == Real(0)) return {-restitution_, Real(0), Real(0), -restitution_};
    return after(time_left(start));
  }

  /// Largest overlap from here on.
  Real deepest(const State& start) const {
    using std::atan2;
    if (start.x == Real(0)) return deepest_ * start.u;
    if (!(start.u > 0)) return start.x;
    return after(atan2(omega_ * start.u, mu_ * start.u + omega0_2_ * start.x) / omega_)(start).x;
  }

  /// The double integral of the contact force F and int F dt when this contact went from `start` to `now` in time t, as
  /// x'' = -inertia F. A neighbouring gap changes by them, over the mass of the bead between.
  State push(const State& start, const State& now, const Real& t) const {
    return {(start.x + start.u * t - now.x) / inertia_, (start.u - now.u) / inertia_};
  }
  /// Upper bound of push().x, as x >= 0.
  Real push_bound(const State& start, const Real& t) const { return (start.x + start.u * t) / inertia_; }

 private:
  static Real pi() {
    using std::acos;
    static const Real value = acos(Real(-1));
    return value;
  }
  static constexpr double least_omega_2 = 0.01;  ///< over omega0^2
  Real inertia_, mu_, omega0_2_, omega_{}, duration_{}, restitution_{}, deepest_{};
  bool oscillates_ = false;
};

}  // namespace sigmasweep
