#include "solve/exact/lattice/energies.hpp"

#include <algorithm>
#include <cmath>

#include "contact/laws/power.hpp"

namespace sigmasweep {

template <class Real, class Ground>
Real LatticeEnergies<Real, Ground>::kinetic(const Real& t) const {
  Real sum = 0;
  for (std::size_t i = 0; i < state_.beads.size(); ++i) {
    const Vec2<Real> v = state_.at(i, t).v;
    sum += state_.lattice.mass(i) * dot(v, v) / 2;
  }
  return sum;
}

template <class Real, class Ground>
Real LatticeEnergies<Real, Ground>::approach(const Real& t) const {
  Real sum = 0;
  for (std::size_t i = 0; i < state_.beads.size(); ++i)
    for (const Neighbour<Real>& other : state_.neighbours.of(i)) {
      if (!other.is_wall() && other.bead < i) continue;
      const Real u = state_.gap(i, other, t).u;
      if (!(u < 0)) continue;
      const Real inertia =
          1 / state_.lattice.mass(i) + (other.is_wall() ? Real(0) : Real(1 / state_.lattice.mass(other.bead)));
      sum += u * u / (2 * inertia);
    }
  return sum;
}

template <class Real, class Ground>
Real LatticeEnergies<Real, Ground>::held(const Real& t) const {
  const PowerLaw law(state_.lattice.beads.exponents);
  const Real K = std::max(state_.lattice.beads.K, state_.lattice.beads.K_wall);
  Real sum = 0;
  for (std::size_t i = 0; i < state_.beads.size(); ++i)
    for (const Neighbour<Real>& other : state_.touching[i]) {
      const Motion<Real> now = state_.gap(i, other, t);
      sum += state_.lattice.mass(i) * now.u * now.u / 2 + law.elastic_energy(K, std::max(Real(-now.x), Real(0)));
    }
  return sum;
}

template <class Real, class Ground>
Real LatticeEnergies<Real, Ground>::energy_at_start() const {
  Real mass = 0;
  for (std::size_t i = 0; i < state_.beads.size(); ++i) mass += state_.lattice.mass(i);
  return mass * state_.lattice.beads.speed * state_.lattice.beads.speed / 2;
}

template <class Real, class Ground>
Real LatticeEnergies<Real, Ground>::later_change(const Real& loss, const Real& t) const {
  using std::sqrt;
  const Real E = kinetic(t), left = std::max(Real(E - loss), Real(0));
  if (loss == Real(0) || E == Real(0)) return Real(0);
  return std::min(loss, E) / (sqrt(energy_at_start()) * (sqrt(E) + sqrt(left)));
}

template <class Real, class Ground>
double LatticeEnergies<Real, Ground>::energy(const Real& t) const requires(Ground::moves) {
  const PowerLaw law(state_.lattice.beads.exponents);
  const double speed = state_.ground.speed(double(t));
  double sum = 0.0;
  for (std::size_t i = 0; i < state_.beads.size(); ++i) {
    const BeadState<Real> state = state_.at(i, t);
    const double x = double(state.v.x), z = double(state.v.z) + speed;
    sum += double(state_.lattice.mass(i)) *
           (0.5 * (x * x + z * z) + state_.ground.g * (double(state.q.z) + state_.ground.height(double(t))));
    for (const Neighbour<Real>& other : state_.touching[i])
      if (const double overlap = -double(state_.gap(i, other, t).x);
          overlap > 0.0 && (other.is_wall() || i < other.bead))
        sum +=
            law.elastic_energy(double(other.is_wall() ? state_.lattice.beads.K_wall : state_.lattice.beads.K), overlap);
  }
  return sum;
}

template class LatticeEnergies<double, FixedWall>;
template class LatticeEnergies<long double, FixedWall>;
template class LatticeEnergies<double, Plate>;

}  // namespace sigmasweep
