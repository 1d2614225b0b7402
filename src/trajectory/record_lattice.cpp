#include "trajectory/record_lattice.hpp"

#include <cmath>
#include <vector>

#include "assembly/lattice.hpp"
#include "assembly/plate_motion.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "solve/fixed_step/collision.hpp"
#include "solve/fixed_step/lattice/observed_collision.hpp"
#include "solve/observer/lattice_samples.hpp"

namespace sigmasweep {
namespace {

/// The clock starts with the fall, or with the plate's motion.
void watch(const Parameters& p, const Lattice<double>& lattice, LatticeSamples& samples) {
  if (is_vibrated(p)) return observe_vibrated_lattice(p, samples);
  if (p.integrator == Integrator::exact) return observe_lattice(lattice, samples);
  observe_fixed_step_lattice(lattice, p.integrator, 1.0 / steps_taken(p), samples);
}

}  // namespace

Trajectory record_lattice(const Parameters& p, std::span<const double> times) {
  const auto lattice = reduced_lattice<double>(p);
  const double time = p.tc, length = p.v0 * p.tc;  // of the solvers' units
  std::vector<double> reduced;
  for (const double t : times) reduced.push_back(t / time);
  LatticeSamples samples(std::move(reduced), lattice.count());
  watch(p, lattice, samples);

  Trajectory t;
  t.time.assign(times.begin(), times.end());
  t.box_width = length * lattice.width();
  t.periodic = lattice.periodic;
  for (std::size_t i = 0; i < lattice.count(); ++i) {
    t.mass.push_back(lattice.mass(i));
    t.diameter.push_back(p.d * std::cbrt(t.mass[i]));
  }
  for (std::size_t s = 0; s < times.size(); ++s) {
    const double plate = is_vibrated(p) ? plate_height(p, times[s]) : 0.0;
    const double plate_velocity = is_vibrated(p) ? plate_speed(p, times[s]) : 0.0;
    for (std::size_t i = 0; i < lattice.count(); ++i) {
      const Vec2<double> r = length * (lattice.site(i) + samples.q(s)[i]);
      const Vec2<double> v = (length / time) * samples.v(s)[i];
      t.x.push_back(r.x);
      t.z.push_back(r.z + plate);
      t.x_velocity.push_back(v.x);
      t.velocity.push_back(v.z + plate_velocity);
    }
  }
  return t;
}

}  // namespace sigmasweep
