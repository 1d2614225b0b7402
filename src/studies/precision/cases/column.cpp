#include "studies/precision/cases/column.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "solve/fixed_step/column/collision.hpp"
#include "solve/fixed_step/scheme_info.hpp"
#include "solve/reference/normal_modes.hpp"

namespace sigmasweep {
namespace {

constexpr double settle = 1e-19;
/// Limits of about ten seconds: a tuple that takes longer is chaotic and has no reference.
constexpr std::uint64_t max_contacts_moved = 10'000'000, max_modes = 300'000'000;

template <class Real>
ReferenceValue reference_value(const Outcome<Real>& outcome, const Column<Real>& column) {
  ReferenceValue result;
  result.known = outcome.status == Status::ok;
  if (!result.known) return result;
  result.value = static_cast<long double>(energies<Real>(outcome.velocity, column.speed, column.mass).eps_eff);
  for (const Real& v : outcome.velocity) result.velocity.push_back(static_cast<double>(v / column.speed));
  return result;
}

template <class Real>
ReferenceValue by_series(const Parameters& p) {
  const Column<Real> column = reduced_column<Real>(p);
  return reference_value<Real>(exact_collision(column, {.settle = settle, .work_limit = max_contacts_moved}), column);
}

ReferenceValue by_modes(const Parameters& p) {
  const auto column = reduced_column<long double>(p);
  return reference_value(normal_modes_collision(column, {.settle = settle, .work_limit = max_modes}), column);
}

Reference by_steps(double accuracy) {
  return [accuracy](const Parameters& p) {
    const auto column = reduced_column<long double>(p);
    return reference_value(nonlinear_collision(column, accuracy, {.settle = settle}), column);
  };
}

/// The final velocities of the exact solver in double, when it stops for this tolerance. If simulate() needs a wider
/// type, its eps_eff is better than these velocities.
std::vector<double> exact_velocities(const Parameters& p) {
  const Column<double> column = reduced_column<double>(p);
  const double left = 1e-3 * p.tolerance;
  if (column.exponents.linear()) return exact_collision(column, {.settle = left}).velocity;
  return nonlinear_collision(column, std::max(1e-3 * p.tolerance, 1e-15), {.settle = left}).velocity;
}

PreparedRun exact_run(const Parameters& p) {
  const auto run = [p] {
    const SimulationResult c = simulate(p);
    return Measurement{.failed = !is_success(c.status), .value = c.eps_eff, .velocity = {}};
  };
  return {run, [p] { return exact_velocities(p); }};
}

/// The wall is further away by a fraction `phase` of the distance that the column flies in a step.
PreparedRun fixed_step_run(const Parameters& p, double phase) {
  const double dt = 1.0 / p.steps_per_tc;
  const auto column = std::make_shared<Column<double>>(reduced_column<double>(p));
  if (column->gaps.empty()) column->gaps.assign(column->contacts(), column->gap);
  column->gaps[0] += phase * dt * column->speed;
  return {[column, dt, integrator = p.integrator] {
    std::uint64_t steps = 0;
    Outcome<double> outcome = fixed_step_collision(*column, integrator, dt, {}, {.steps = &steps});
    Measurement found{.failed = !is_success(outcome.status),
                      .value = energies<double>(outcome.velocity, column->speed, column->mass).eps_eff};
    found.velocity = std::move(outcome.velocity);
    found.evaluations = static_cast<double>(steps) * scheme_info(integrator).evaluations;
    return found;
  }};
}

}  // namespace

PrecisionCase column_case(const Parameters& scene, const PrecisionSpec& spec) {
  PrecisionCase column{
      .tuples = with_other_sigmas(scene, spec), .reference = by_series<long double>, .check = by_modes};
  column.independent = true;
  if (!exponents(scene).linear()) {
    column.reference = by_steps(1e-17);
    column.check = by_steps(1e-14);
    column.independent = false;
  } else if (scene.width > 0.0) {
    column.check = by_series<Quad>;
    column.check_is_better = true;
    column.independent = false;
  }
  column.prepare = [](const Parameters& p, double phase) {
    return p.integrator == Integrator::exact ? exact_run(p) : fixed_step_run(p, phase);
  };
  return column;
}

}  // namespace sigmasweep
