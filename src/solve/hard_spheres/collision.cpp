#include "solve/hard_spheres/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "assembly/energies.hpp"
#include "numerics/noise.hpp"
#include "sigmasweep/contact/calibration.hpp"
#include "solve/hard_spheres/column.hpp"
#include "solve/observer/samples.hpp"
#include "solve/to_si.hpp"

namespace sigmasweep {

Outcome<double> hard_sphere_collision(const Column<double>& column, const HardSphereSettings& settings,
                                      const RunLimits& limits) {
  NullObserver nobody;
  Outcome<double> outcome = HardSphereColumn(column, settings, limits).run(nobody);
  for (double& v : outcome.velocity) v *= column.speed;
  outcome.t_k *= length_of(column) / column.speed;
  return outcome;
}

void observe_hard_spheres(const Column<double>& column, EdRule rule, Samples& samples) {
  HardSphereColumn(column, {.rule = rule}, {.settle = 0.0}).run(samples);  // to the last sample
}

namespace {

/// Largest number of collisions in the wide type: about half a second.
constexpr std::uint64_t quad_limit = 150'000;

/// `column` with changes in the last bits of eps, the wall's restitution, and unequal masses and gaps.
template <class Real>
Column<Real> twin_of(Column<Real> column) {
  const Real bits = 16 * std::numeric_limits<Real>::epsilon();
  const bool matched = column.eps_wall == column.eps;
  column.eps *= 1 - bits;
  column.eps_wall = matched ? column.eps : wall_restitution(column.eps);
  Noise noise;
  for (Real& gap : column.gaps) gap *= 1 + bits * noise.next();
  for (Real& mass : column.mass) mass *= 1 + bits * noise.next();
  return column;
}

struct Computed {
  SimulationResult result;
  double clock_resolution_error;  ///< see HardSphereColumn
  double t_k;                     ///< in units of length_of() over the speed
  std::uint64_t collisions;       ///< of the run and of its twin, the larger number
};

template <class Real>
Computed computed_in(const Parameters& p, HardSphereSettings settings, const RunLimits& limits) {
  using std::abs;
  const Column<Real> column = reduced_column<Real>(p);
  const std::span<const Real> mass = column.mass;
  NullObserver nobody;
  HardSphereColumn<Real> run(column, settings, limits);
  Outcome<Real> outcome = run.run(nobody);
  std::uint64_t collisions = outcome.contacts;
  const double collisions_per_bead = static_cast<double>(collisions) / static_cast<double>(p.N);
  if (outcome.end == End::settled && settings.rule == EdRule::lrv) run.add_late_collisions(outcome);
  const double t_k = static_cast<double>(outcome.t_k);
  outcome.t_k *= length_of(column);
  const bool given_up = outcome.status == Status::event_limit;
  if (given_up) outcome.status = Status::tolerance_missed;  // by the energy that can still be dissipated
  SimulationResult c = to_si_result(outcome, p, mass);
  const Real roundings = std::numeric_limits<Real>::epsilon() * spread(column.mass) * (4 + collisions_per_bead);
  const Real left = residual_dissipation<Real>(outcome.velocity, Real(1), mass);
  Real error = roundings + left, apart = 0;
  if (!given_up) {
    // The twin has more simultaneous collisions, which matter in columns that come close to a collapse.
    const Column<Real> twin = twin_of(column);
    settings.same_time *= 64.0;
    settings.collapsed_speed *= 64.0;
    const Outcome<Real> other = HardSphereColumn<Real>(twin, settings, limits).run(nobody);
    error += abs(energies<Real>(outcome.velocity, Real(1), mass).eps_eff -
                 energies<Real>(other.velocity, Real(1), twin.mass).eps_eff);
    apart = distance<Real>(outcome.velocity, other.velocity, mass);
    collisions = std::max(collisions, other.contacts);
  }
  if (std::isfinite(c.eps_eff)) {
    c.eps_eff_error = static_cast<double>(error) + 0.5 * std::numeric_limits<double>::epsilon() * c.eps_eff;
    const double late = static_cast<double>(left) + static_cast<double>(run.clock_resolution_error());
    set_errors_of_motion(c, static_cast<double>(roundings + apart) + velocity_left(c.eps_eff, late));
  }
  return {c, static_cast<double>(run.clock_resolution_error()), t_k, collisions};
}

/// The result with the smaller error. If the resolution of time limits both, their difference bounds its error; but not
/// in the TC model, where the order of collisions that neither of them resolves decides which of them dissipate.
SimulationResult better_of(const Computed& fast, const Computed& wide, const Parameters& p) {
  const SimulationResult &f = fast.result, &w = wide.result;
  const double fast_error = f.eps_eff_error + fast.clock_resolution_error;
  const double difference = p.ed_rule == EdRule::tc ? 1.0 : std::fabs(f.eps_eff - w.eps_eff);
  const double wide_error = w.eps_eff_error + std::min(wide.clock_resolution_error, difference);
  return wide_error < fast_error ? with_error(w, wide_error, p.tolerance) : with_error(f, fast_error, p.tolerance);
}

/// In double, and if that is not good enough in the wide type.
SimulationResult good_enough(const Parameters& p, HardSphereSettings settings, ComputeBudget* budget) {
  RunLimits limits{.settle = 1e-3 * p.tolerance, .budget = budget};
  const Computed fast = computed_in<double>(p, settings, limits);
  const SimulationResult& c = fast.result;
  const double error = c.eps_eff_error + fast.clock_resolution_error;
  if (error <= p.tolerance || !(c.contacts <= quad_limit)) return with_error(c, error, p.tolerance);
  limits.event_limit = quad_limit;
  settings.same_time = 1e-28;
  settings.collapsed_speed = 1e-30;
  return better_of(fast, computed_in<Quad>(p, settings, limits), p);
}

}  // namespace

SimulationResult simulate_hard_spheres(const Parameters& p, ComputeBudget* budget) {
  const SimulationResult c = good_enough(p, {.rule = p.ed_rule}, budget);
  if (c.end != End::none || c.status != Status::tolerance_missed || p.ed_rule == EdRule::tc) return c;
  // Too many collisions, as in collapses upon collapses of unequal beads: the same ones are done once.
  const SimulationResult again = good_enough(p, {.rule = p.ed_rule, .remember_hits = true}, budget);
  return again.end == End::none ? c : again;
}

std::optional<HardSphereResult> short_hard_sphere_run(const Parameters& p) {
  constexpr std::uint64_t most = 20'000;
  const RunLimits limits{.settle = 1e-3 * p.tolerance, .event_limit = most};
  const Computed fast = computed_in<double>(p, {.rule = p.ed_rule}, limits);
  const double error = fast.result.eps_eff_error + fast.clock_resolution_error;
  if (!(error <= p.tolerance) || fast.collisions >= most || !is_success(fast.result.status)) return std::nullopt;
  return HardSphereResult{with_error(fast.result, error, p.tolerance), fast.t_k};
}

}  // namespace sigmasweep
