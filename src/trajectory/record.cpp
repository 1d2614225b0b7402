#include "sigmasweep/trajectory/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "assembly/plate_motion.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "solve/exact/linear/column.hpp"
#include "solve/exact/power_law/column.hpp"
#include "solve/fixed_step/collision.hpp"
#include "solve/fixed_step/column/observed_collision.hpp"
#include "solve/observer/samples.hpp"
#include "trajectory/record_lattice.hpp"

namespace sigmasweep {
namespace {

/// What a solver's units are in SI, and when its clock starts.
struct Units {
  double time, length;  ///< s, m
  double start;         ///< s after the start of the fall
};

/// Samples of the fall before the clock starts: uniform motion.
void fall(const Column<double>& column, double t, std::span<double> x, std::span<double> u) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = -column.initial_gap(k);
    u[k] = 0.0;
  }
  x[0] += column.speed * t;
  u[0] = column.speed;
}

Units units_of(const Parameters& p, const Column<double>& column) {
  if (is_vibrated(p)) return {vibration_units(p).time, vibration_units(p).length, 0.0};
  if (p.method == Method::ed) {
    if (p.s0 > 0.0) return {p.s0 / p.v0, p.s0, 0.0};
    return {p.tc, p.v0 * p.tc, 0.0};
  }
  const double first_contact = column.initial_gap(0) / column.speed * p.tc;
  const bool from_the_start = p.integrator != Integrator::exact;
  return {p.tc, p.v0 * p.tc, from_the_start ? 0.0 : first_contact};
}

void observe_vibrated(const Parameters& p, Samples& samples) {
  VibratedSamples vibrated(samples, Plate::of(p, vibration_units(p)).period());
  p.method == Method::ed ? observe_vibrated_hard_spheres(p, vibrated) : observe_vibrated_soft_spheres(p, vibrated);
}

void watch(const Parameters& p, const Column<double>& column, Samples& samples) {
  if (is_vibrated(p)) return observe_vibrated(p, samples);
  if (p.method == Method::ed) return observe_hard_spheres(column, p.ed_rule, samples);
  if (p.integrator != Integrator::exact) return observe_fixed_step(column, p.integrator, 1.0 / steps_taken(p), samples);
  const double start = -column.initial_gap(0) / column.speed;
  const auto falling = [&](double t, auto x, auto u) { fall(column, t - start, x, u); };
  samples.until(std::nextafter(0.0, -1.0), falling);
  if (column.exponents.linear()) return observe_exact(column, samples);
  observe_nonlinear(column, samples);
}

/// z_i = plate - (x_0 + ... + x_i), v_i the same with u.
void add_up(std::span<const double> of_contacts, double unit, double plate, std::vector<double>& of_beads) {
  double sum = 0.0;
  for (const double value : of_contacts) of_beads.push_back(plate - unit * (sum += value));
}

}  // namespace

double Trajectory::base(std::size_t bead) const {
  if (is_plane()) return 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < bead; ++i) below += diameter[i];
  return below + 0.5 * diameter[bead];
}

Trajectory record(const Parameters& p, std::span<const double> times) {
  if (is_lattice(p)) return record_lattice(p, times);
  const Column<double> column = reduced_column<double>(p);
  const Units units = units_of(p, column);
  std::vector<double> reduced;
  for (const double t : times) reduced.push_back((t - units.start) / units.time);
  Samples samples(std::move(reduced), column.contacts());
  watch(p, column, samples);

  const bool vibrates = is_vibrated(p);
  Trajectory trajectory;
  trajectory.time.assign(times.begin(), times.end());
  for (std::size_t s = 0; s < times.size(); ++s) {
    add_up(samples.x(s), units.length, vibrates ? plate_height(p, times[s]) : 0.0, trajectory.z);
    add_up(samples.u(s), units.length / units.time, vibrates ? plate_speed(p, times[s]) : 0.0, trajectory.velocity);
  }
  trajectory.mass = column.is_uniform() ? std::vector<double>(column.contacts(), 1.0) : column.mass;
  for (const double mass : trajectory.mass) trajectory.diameter.push_back(p.d * std::cbrt(mass));
  return trajectory;
}

void observe_exact(const Column<double>& column, Samples& samples) {
  ExactOptions options;
  options.settle = 0.0;  // to the last sample
  if (column.is_uniform())
    ExactColumn<double, 0, false>(column, options).run(samples);
  else
    ExactColumn<double, 0, true>(column, options).run(samples);
}

void observe_nonlinear(const Column<double>& column, Samples& samples) {
  NonlinearOptions options;
  options.settle = 0.0;
  NonlinearColumn<double>(column, options).run(samples);
}

double show_time(const Parameters& p, const SimulationResult& collision) {
  constexpr double shown_periods = 10.0;
  if (is_vibrated(p))
    return std::isnan(collision.vibration.h_cm) ? collision.vibration.h_cm : shown_periods / p.frequency;
  // sigma tc = s0/v0
  const double first_contact = is_lattice(p) ? p.sigma * p.tc : reduced_column<double>(p).initial_gap(0) * p.tc;
  const double last_contact = first_contact + collision.t_k;
  if (is_lattice(p) && !std::isnan(last_contact))
    return std::min(1.5 * last_contact,
                    first_contact + 3.0 * static_cast<double>(p.rows) * (p.tc + (p.s0 + p.width) / p.v0));
  if (last_contact > 0.0 || std::isnan(last_contact)) return 1.5 * last_contact;
  return 1.5 * static_cast<double>(p.N) * p.tc;
}

std::vector<double> sample_times(double duration, std::size_t count) {
  std::vector<double> times(count);
  const double last = static_cast<double>(count - 1);
  for (std::size_t s = 0; s < count; ++s) times[s] = duration * (static_cast<double>(s) / last);
  return times;
}

}  // namespace sigmasweep
