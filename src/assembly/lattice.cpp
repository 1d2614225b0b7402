#include "assembly/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "assembly/neighbours.hpp"
#include "base/random.hpp"

namespace sigmasweep {

template <class Real>
Real Lattice<Real>::width() const {
  const Real c(static_cast<double>(columns));
  return periodic ? Real(c * a) : Real((c + Real(0.5)) * a + beads.gap);
}

template <class Real>
Real Lattice<Real>::quiet_time() const {
  return 2 * Real(double(count())) * (beads.gap + 2 * (largest - d)) / beads.speed;
}

template <class Real>
Real Lattice<Real>::rounding() const {
  const Real flight = beads.gap * Real(double(rows)) / (beads.speed * beads.tc);
  return 16 * std::numeric_limits<Real>::epsilon() * flight;
}

template <class Real>
Real Lattice<Real>::diameter(std::size_t i) const {
  using std::cbrt;
  return beads.is_uniform() ? d : Real(d * cbrt(beads.mass[i]));
}

template <class Real>
Vec2<Real> Lattice<Real>::site(std::size_t i) const {
  const auto per_row = static_cast<std::size_t>(columns);
  const Real row(static_cast<double>(i / per_row)), place(static_cast<double>(i % per_row));
  const Real first = (a + beads.gap) / 2;  // its gap to the walls: that of the largest bead
  const Real half = (i / per_row) % 2 == 1 ? Real(0.5) : Real(0);
  return {(periodic ? Real(0) : first) + (place + half) * a, first + row * a * (std::numbers::sqrt3_v<Real> / 2)};
}

template <class Real>
Lattice<Real> reduced_lattice(const Parameters& p) {
  Parameters of_beads = p;
  of_beads.random_separation = Flag::no;
  Lattice<Real> lattice;
  lattice.beads = reduced_column<Real>(of_beads);
  lattice.rows = p.rows;
  lattice.columns = p.columns;
  const Real unit = Real(p.v0) * Real(p.tc);
  lattice.d = Real(p.d) / unit;
  lattice.largest = lattice.d + Real(p.width) / (2 * unit);
  lattice.a = lattice.largest + lattice.beads.gap;
  lattice.D_t = Real(p.D_t) * Real(p.tc);
  lattice.periodic = p.side_walls == SideWalls::periodic;
  if (p.random_separation == Flag::yes && lattice.beads.gap > Real(0))
    shift_at_random(lattice, stream_key(static_cast<std::uint64_t>(p.seed), "separation"));
  return lattice;
}

template <class Real>
void shift_at_random(Lattice<Real>& lattice, std::uint64_t key) {
  lattice.shift.assign(lattice.count(), {});
  std::uint64_t drawn = 0;
  const auto draw = [&] { return lattice.beads.gap * (Real(unit_interval(random_bits(key, drawn++))) - Real(0.5)); };
  LatticeNeighbours<Real> neighbours(lattice);
  for (std::size_t i = 0; i < lattice.count(); ++i) {
    const auto overlaps = [&] {
      return std::ranges::any_of(neighbours.of(i), [&](const Neighbour<Real>& other) {
        return !other.is_wall() && other.bead < i &&
               other.bond.gap(lattice.shift[i] - lattice.shift[other.bead]) < Real(0);
      });
    };
    do {
      const Real x = draw();
      lattice.shift[i] = {x, draw()};
    } while (overlaps());
  }
}

template <class Real>
Energies<Real> energies(const Lattice<Real>& lattice, const std::vector<Vec2<Real>>& velocity) {
  using std::sqrt;
  Real mass = 0, final = 0, relative = 0;
  Vec2<Real> momentum;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    mass += lattice.mass(i);
    momentum += lattice.mass(i) * velocity[i];
    final += lattice.mass(i) * dot(velocity[i], velocity[i]);
  }
  const Vec2<Real> centre = (1 / mass) * momentum;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const Vec2<Real> v = velocity[i] - centre;
    relative += lattice.mass(i) * dot(v, v);
  }
  const Real initial = mass * lattice.beads.speed * lattice.beads.speed;
  return {sqrt(final / initial), final > Real(0) ? Real(relative / final) : Real(0), relative / initial,
          centre.z / lattice.beads.speed};
}

template struct Lattice<double>;
template struct Lattice<long double>;
template Lattice<double> reduced_lattice(const Parameters&);
template Lattice<long double> reduced_lattice(const Parameters&);
template void shift_at_random(Lattice<double>&, std::uint64_t);
template void shift_at_random(Lattice<long double>&, std::uint64_t);
template Energies<double> energies(const Lattice<double>&, const std::vector<Vec2<double>>&);
template Energies<long double> energies(const Lattice<long double>&, const std::vector<Vec2<long double>>&);

}  // namespace sigmasweep
