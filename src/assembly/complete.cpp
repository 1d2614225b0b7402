#include "sigmasweep/assembly/complete.hpp"

#include <cmath>
#include <numbers>

#include "sigmasweep/contact/calibration.hpp"
#include "sigmasweep/contact/materials.hpp"
#include "sigmasweep/contact/pair_collision.hpp"
#include "sigmasweep/model/geometry.hpp"

namespace sigmasweep {

/// Spring from the elasticity, Sec. III B, dashpot from the restitution at 1 m/s. For the linear law both from the
/// contact time that Hertz's has at 1 m/s.
void derive_material(Parameters& p) {
  if (p.material == Material::none) return;
  constexpr double reference_speed = 1.0;
  const Bead& bead = sigmasweep::bead(p.material);
  const auto law_of = [&](Exponents e) {
    return PairLaw{e, elastic_constant(bead) * std::pow(bead.d, 1.0 - e.beta) / (0.5 * bead.mass), 0.0};
  };
  p.d = bead.d;
  if (const Exponents e = exponents(p); e.linear()) {
    const double tc = theory::contact_time(law_of({0.5, 0.0}), reference_speed);
    const Oscillator<double> pair = oscillator(tc, bead.epsilon);
    p.K_over_m = pair.omega0_2;
    p.D_n = pair.mu;
  } else {
    p.K_over_m = law_of(e).k;
    p.D_n = 0.5 * damping(e, p.K_over_m, reference_speed, bead.epsilon);
  }
}

/// tc and epsilon at v0 from K_over_m and D_n. A pair that never comes apart has no contact time: the one without
/// damping, pi/sqrt(K_over_m), is the unit of time then, as (A2) is for the other laws.
void derive_pair(Parameters& p) {
  if (!(p.K_over_m > 0.0)) return;
  const PairLaw law{exponents(p), p.K_over_m, 2.0 * p.D_n};
  const PairCollision pair = collide(law, p.v0);
  p.epsilon = pair.eps;
  if (!law.exponents.linear())
    p.tc = theory::contact_time(law, p.v0);
  else
    p.tc = pair.eps > 0.0 ? pair.duration : std::numbers::pi / std::sqrt(p.K_over_m);
}

/// One product for both ways: rows with the same s0, v0, tc get the same sigma to the bit. Nothing to divide when
/// s0 = 0, so that a v0 tc too small for a double does no harm there. A vibrated column has no speed to measure gaps
/// by.
void derive_gap(Parameters& p, GapParameter given) {
  const double unit_length = p.v0 * p.tc;
  if (given == GapParameter::s0 || is_vibrated(p))
    p.sigma = p.s0 == 0.0 ? 0.0 : p.s0 / unit_length;
  else
    p.s0 = p.sigma * unit_length;
}

void derive_plate_motion(Parameters& p) {
  if (!is_vibrated(p)) return;
  const double omega = 2.0 * std::numbers::pi * p.frequency, unit = p.gravity / (omega * omega);
  if (!(p.A0 > 0.0))
    p.A0 = p.alpha * unit;
  else if (p.alpha * unit != p.A0)
    p.alpha = p.A0 / unit;
}

void derive_beads(Parameters& p) {
  if (is_lattice(p)) p.N = p.rows * p.columns;
}

Parameters complete(Parameters parameters, GapParameter given) {
  derive_beads(parameters);
  derive_material(parameters);
  derive_pair(parameters);
  derive_gap(parameters, given);
  derive_plate_motion(parameters);
  return parameters;
}

}  // namespace sigmasweep
