#pragma once

/// Spring and dashpot of the linear law from contact time and restitution, and back; Eqs. (5)-(7) and the wall.
namespace sigmasweep {

/// x'' + 2 mu x' + omega0^2 x = 0 for the overlap x of a pair, Eq. (5).
template <class Real>
struct Oscillator {
  Real mu{};        ///< damping rate, 1/time
  Real omega0_2{};  ///< omega0^2, 1/time^2
};

/// mu = L/tc, omega0^2 = (pi/tc)^2 + mu^2, L = -ln eps; from Eqs. (6), (7). Any tc > 0, 0 < eps <= 1.
template <class Real>
Oscillator<Real> oscillator(Real tc, Real eps);

/// tc = pi/sqrt(omega0^2 - mu^2), Eq. (6). Underdamped only (mu < omega0); NaN otherwise.
template <class Real>
Real contact_time(const Oscillator<Real>& pair);

/// eps = exp(-mu tc), Eq. (7). Underdamped only; NaN otherwise.
template <class Real>
Real restitution(const Oscillator<Real>& pair);

/// The wall with a pair's spring and dashpot: the bead moves with its whole mass, so mu_wall = mu/2 and
/// omega_wall^2 = omega0^2/2.
template <class Real>
Oscillator<Real> wall_of(const Oscillator<Real>& pair);

/// eps_wall = exp(-pi L/sqrt(2 pi^2 + L^2)): restitution(wall_of(pair)) in a form that is good for every 0 < eps <= 1.
template <class Real>
Real wall_restitution(Real eps);

}  // namespace sigmasweep
