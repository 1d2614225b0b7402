#include "lattice_trajectory.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "lattice_samples.hpp"
#include "sigmasweep/solve/lattice.hpp"

namespace sigmasweep {
namespace {

/// What the solver's units are in SI; its clock starts with the fall.
struct Units {
  double time, length;  ///< s, m
};

Units units_of(const Parameters& p) { return {p.tc, p.v0 * p.tc}; }

void watch(const Parameters& p, const Lattice<double>& lattice, LatticeSamples& samples) {
  if (p.geometry != Geometry::lattice) throw std::invalid_argument("vibrated lattices are not recorded");
  if (p.integrator == Integrator::exact) return watch_lattice(lattice, samples);
  watch_fixed_step_lattice(lattice, p.integrator, 1.0 / p.steps_per_tc, samples);
}

}  // namespace

Trajectory record_lattice(const Parameters& p, std::span<const double> times) {
  const auto lattice = reduced_lattice<double>(p);
  const Units units = units_of(p);
  std::vector<double> reduced;
  for (const double t : times) reduced.push_back(t / units.time);
  LatticeSamples samples(std::move(reduced), lattice.count());
  watch(p, lattice, samples);

  Trajectory t;
  t.time.assign(times.begin(), times.end());
  t.box_width = units.length * lattice.width();
  t.periodic = lattice.periodic;
  for (std::size_t i = 0; i < lattice.count(); ++i) {
    t.mass.push_back(lattice.mass(i));
    t.diameter.push_back(p.d * std::cbrt(t.mass[i]));
  }
  for (std::size_t s = 0; s < times.size(); ++s)
    for (std::size_t i = 0; i < lattice.count(); ++i) {
      const Vec2<double> r = units.length * (lattice.site(i) + samples.q(s)[i]);
      const Vec2<double> v = (units.length / units.time) * samples.v(s)[i];
      t.x.push_back(r.x);
      t.z.push_back(r.z);
      t.x_velocity.push_back(v.x);
      t.velocity.push_back(v.z);
    }
  return t;
}

}  // namespace sigmasweep
