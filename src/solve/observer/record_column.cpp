#include "solve/observer/record_column.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "assembly/diameters.hpp"
#include "assembly/ground.hpp"

namespace sigmasweep {
namespace {

/// A solver's units in SI, and the origin of its time.
struct Units {
  double time, length;  ///< s, m
  double start;         ///< origin of the solver's time, s after the start of the fall
  bool on_plate;        ///< overlaps and rates are relative to the plate
};

/// Overlaps and rates at time t of the fall before the solver starts, a uniform motion.
void fall(const Column<double>& column, double t, std::span<double> x, std::span<double> u) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = -column.initial_gap(k);
    u[k] = 0.0;
  }
  x[0] += column.speed * t;
  u[0] = column.speed;
}

/// Adds the heights of all beads, z_i = plate - (x_0 + ... + x_i), or their velocities from the rates.
void add_up(std::span<const double> of_contacts, double unit, double plate, std::vector<double>& of_beads) {
  double sum = 0.0;
  for (const double value : of_contacts) of_beads.push_back(plate - unit * (sum += value));
}

/// The trajectory of a column whose samples watch(samples) takes. Not inlined, so that units are rounded before use.
template <class Watch>
[[gnu::noinline]] Trajectory record(const Parameters& p, std::span<const double> times, const Column<double>& column,
                                    const Units& units, const Watch& watch) {
  std::vector<double> reduced;
  for (const double t : times) reduced.push_back((t - units.start) / units.time);
  Samples samples(std::move(reduced), column.contacts());
  watch(samples);

  Trajectory trajectory;
  trajectory.time.assign(times.begin(), times.end());
  for (std::size_t s = 0; s < times.size(); ++s) {
    add_up(samples.x(s), units.length, units.on_plate ? plate_height(p, times[s]) : 0.0, trajectory.z);
    add_up(samples.u(s), units.length / units.time, units.on_plate ? plate_speed(p, times[s]) : 0.0,
           trajectory.velocity);
  }
  trajectory.mass = column.is_uniform() ? std::vector<double>(column.contacts(), 1.0) : column.mass;
  trajectory.diameter = column.is_uniform() ? std::vector<double>(column.contacts(), p.d) : diameters(p);
  return trajectory;
}

}  // namespace

Trajectory record_from_start(const Parameters& p, std::span<const double> times, ObserveColumn observe) {
  const auto column = reduced_column<double>(p);
  const Units units{p.tc, p.v0 * p.tc, 0.0, false};
  return record(p, times, column, units, [&](Samples& samples) { observe(p, column, samples); });
}

Trajectory record_from_first_contact(const Parameters& p, std::span<const double> times, ObserveColumn observe) {
  const auto column = reduced_column<double>(p);
  const double flight = column.initial_gap(0) / column.speed;
  const Units units{p.tc, p.v0 * p.tc, flight * p.tc, false};
  return record(p, times, column, units, [&](Samples& samples) {
    const double start = -flight;
    samples.until(std::nextafter(0.0, -1.0), [&](double t, auto x, auto u) { fall(column, t - start, x, u); });
    observe(p, column, samples);
  });
}

Trajectory record_in_gaps(const Parameters& p, std::span<const double> times, ObserveColumn observe) {
  const auto column = reduced_column<double>(p);
  const Units units = p.s0 > 0.0 ? Units{p.s0 / p.v0, p.s0, 0.0, false} : Units{p.tc, p.v0 * p.tc, 0.0, false};
  return record(p, times, column, units, [&](Samples& samples) { observe(p, column, samples); });
}

Trajectory record_on_plate(const Parameters& p, std::span<const double> times, ObserveVibrated observe) {
  const auto column = reduced_column<double>(p);
  const VibrationUnits plate = vibration_units(p);
  return record(p, times, column, {plate.time, plate.length, 0.0, true}, [&](Samples& samples) {
    VibratedSamples vibrated(samples, Plate::of(p, plate).period());
    observe(p, vibrated);
  });
}

}  // namespace sigmasweep
