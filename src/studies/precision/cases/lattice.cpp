#include "studies/precision/cases/lattice.hpp"

#include <algorithm>
#include <memory>

#include "assembly/lattice.hpp"
#include "base/random.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/lattice/collision.hpp"
#include "solve/fixed_step/lattice/collision.hpp"

namespace sigmasweep {
namespace {

/// Limit of about half a minute, in stages of steps times beads and contacts: a slower tuple has no reference.
constexpr std::uint64_t max_work = 200'000'000;

template <class Real>
std::vector<double> velocities(const Lattice<Real>& lattice, const LatticeOutcome<Real>& outcome) {
  std::vector<double> components;
  for (const Vec2<Real>& v : outcome.velocity)
    for (const Real& component : {v.x, v.z}) components.push_back(static_cast<double>(component / lattice.beads.speed));
  return components;
}

Reference by_steps(double accuracy) {
  return [accuracy](const Parameters& p) {
    const auto lattice = reduced_lattice<long double>(p);
    const auto outcome = lattice_collision(lattice, accuracy, {.settle = 1e-17, .work_limit = max_work});
    ReferenceValue a;
    a.known = outcome.status == Status::ok;
    if (!a.known) return a;
    a.value = energies(lattice, outcome.velocity).eps_eff;
    a.velocity = velocities(lattice, outcome);
    return a;
  };
}

/// The final velocities of the first run that the exact solver of lattices makes for this tolerance, in double.
std::vector<double> exact_velocities(const Parameters& p) {
  const auto lattice = reduced_lattice<double>(p);
  const double accuracy = std::clamp(1e-3 * p.tolerance, 1e-15, 1e-8);
  return velocities(lattice, lattice_collision(lattice, accuracy, {.settle = 1e-3 * p.tolerance}));
}

PreparedRun exact_run(const Parameters& p, double longest) {
  const auto run = [p, longest] {
    ComputeBudget budget(longest);
    const SimulationResult c = simulate(p, &budget);
    return Measurement{.failed = !is_success(c.status), .value = c.eps_eff};
  };
  return {run, [p] { return exact_velocities(p); }};
}

/// All beads are higher by a fraction `phase` of the distance that they fly in a step.
PreparedRun fixed_step_run(const Parameters& p, double phase, double longest) {
  const double dt = 1.0 / p.steps_per_tc;
  const auto lattice = std::make_shared<Lattice<double>>(reduced_lattice<double>(p));
  lattice->shift.resize(lattice->count());
  for (Vec2<double>& shift : lattice->shift) shift.z += phase * dt * lattice->beads.speed;
  return {.run = [lattice, dt, longest, integrator = p.integrator] {
    ComputeBudget budget(longest);
    const auto outcome = fixed_step_lattice_collision(*lattice, integrator, dt, {.budget = &budget});
    return Measurement{.failed = !is_success(outcome.status),
                       .value = energies(*lattice, outcome.velocity).eps_eff,
                       .velocity = velocities(*lattice, outcome)};
  }};
}

}  // namespace

PrecisionCase lattice_case(const Parameters& scene, const PrecisionSpec& spec) {
  PrecisionCase lattice{
      .tuples = with_other_sigmas(scene, spec), .reference = by_steps(1e-15), .check = by_steps(1e-13)};
  if (scene.random_separation == Flag::yes)
    for (std::size_t k = 0; k < lattice.tuples.size(); ++k)
      lattice.tuples[k].seed = static_cast<std::int64_t>(random_bits(stream_key(spec.seed, "shifts"), k) >> 1);
  lattice.prepare = [longest = too_long * spec.longest](const Parameters& p, double phase) {
    return p.integrator == Integrator::exact ? exact_run(p, longest) : fixed_step_run(p, phase, longest);
  };
  return lattice;
}

}  // namespace sigmasweep
