#include "solve/observer/record_lattice.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "assembly/diameters.hpp"
#include "assembly/ground.hpp"

namespace sigmasweep {
namespace {

/// The trajectory of a lattice whose samples watch(samples) takes, on a plate relative to it.
template <class Watch>
Trajectory record(const Parameters& p, std::span<const double> times, const Lattice<double>& lattice, bool on_plate,
                  const Watch& watch) {
  const double time = p.tc, length = p.v0 * p.tc;  // the solvers' units, s and m
  std::vector<double> reduced;
  for (const double t : times) reduced.push_back(t / time);
  LatticeSamples samples(std::move(reduced), lattice.count());
  watch(samples);

  Trajectory t;
  t.time.assign(times.begin(), times.end());
  t.box_width = length * lattice.width();
  t.periodic = lattice.periodic;
  for (std::size_t i = 0; i < lattice.count(); ++i) t.mass.push_back(lattice.mass(i));
  t.diameter = lattice.beads.is_uniform() ? std::vector<double>(lattice.count(), p.d) : diameters(p);
  for (std::size_t s = 0; s < times.size(); ++s) {
    const double plate = on_plate ? plate_height(p, times[s]) : 0.0;
    const double plate_velocity = on_plate ? plate_speed(p, times[s]) : 0.0;
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

}  // namespace

Trajectory record_lattice(const Parameters& p, std::span<const double> times, ObserveLattice observe) {
  const auto lattice = reduced_lattice<double>(p);
  return record(p, times, lattice, false, [&](LatticeSamples& samples) { observe(p, lattice, samples); });
}

Trajectory record_lattice_on_plate(const Parameters& p, std::span<const double> times, ObserveVibratedLattice observe) {
  const auto lattice = reduced_lattice<double>(p);
  return record(p, times, lattice, true, [&](LatticeSamples& samples) {
    VibratedLatticeSamples vibrated(samples, Plate::of(p, vibration_units(p)).period());
    observe(p, vibrated);
  });
}

}  // namespace sigmasweep
