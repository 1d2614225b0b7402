#include "solve/fixed_step/collision.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/lattice.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/fixed_step/column/collision.hpp"
#include "solve/fixed_step/lattice/collision.hpp"
#include "solve/fixed_step/stability.hpp"
#include "solve/to_si.hpp"

namespace sigmasweep {

namespace {

constexpr double hopeless = 1e5;                        // growth in one tc
constexpr double dense = 0.1;                           // sigma up to which the column is closed as a whole for a while
constexpr double fewest_steps = 20.0, max_steps = 1e6;  // a tc
constexpr double max_work = 1e9;                        // steps times contacts of a collision
constexpr double margin = 1.2, least_factor = 1.5, max_factor = 16.0;

/// The collision in steps of tc/steps_per_tc, without an error. At most `work`, beads times steps; 0: some minutes.
SimulationResult stepped(const Parameters& p, double work, ComputeBudget* budget) {
  const double dt = 1.0 / p.steps_per_tc;
  const RunLimits limits{
      .settle = 1e-3 * p.tolerance, .work_limit = static_cast<std::uint64_t>(work), .budget = budget};
  if (is_lattice(p)) {
    const auto lattice = reduced_lattice<double>(p);
    const auto outcome = fixed_step_lattice_collision(lattice, p.integrator, dt, limits);
    return to_si_result(energies(lattice, outcome.velocity), outcome, p);
  }
  const auto column = reduced_column<double>(p);
  return to_si_result<double>(fixed_step_collision(column, p.integrator, dt, limits), p, column.mass);
}

/// With the distance to the exact result as the error.
SimulationResult compared(SimulationResult c, const SimulationResult& exact) {
  if (!is_success(c.status)) return c;
  // Both lie between 0 and 1 where nothing better is known.
  const double worst = std::max(c.eps_eff, std::fabs(1.0 - c.eps_eff));
  const double error = std::fabs(c.eps_eff - exact.eps_eff) + exact.eps_eff_error;
  c.eps_eff_error = error <= worst ? error : worst;
  const auto at_most_one = [](double distance) { return distance <= 1.0 ? distance : 1.0; };
  c.Er_Ef_error = at_most_one(std::fabs(c.Er_Ef - exact.Er_Ef) + exact.Er_Ef_error);
  c.v_cm_error = at_most_one(std::fabs(c.v_cm - exact.v_cm) + exact.v_cm_error);
  return c;
}

SimulationResult exact_of(Parameters p, ComputeBudget* budget) {
  p.integrator = Integrator::exact;
  return simulate(p, budget);
}

/// Beads that meet one by one are stable where the closed column is not, and of a lattice's motions some may never
/// begin; what is sure is that one bead meets the wall.
bool is_hopeless(const Parameters& p) {
  Column<double> column = reduced_column<double>(p);
  if (!column.is_uniform()) return false;
  if (is_lattice(p) || p.sigma > dense) column.N = 1;
  return growth_in_a_contact(closed_contacts(column), p.integrator, 1.0 / p.steps_per_tc) > hopeless;
}

SimulationResult with_given_steps(const Parameters& p, ComputeBudget* budget) {
  SimulationResult c;
  c.status = Status::unstable;
  if (!is_hopeless(p)) c = stepped(p, 0.0, budget);
  if (is_success(c.status)) c = compared(c, exact_of(p, budget));
  c.predicted_growth = predicted_growth(p);
  c.steps_used = p.steps_per_tc;
  return c;
}

SimulationResult with_chosen_steps(Parameters p, ComputeBudget* budget) {
  const double tolerance = p.tolerance;
  p.tolerance = std::max(0.1 * tolerance, 1e-15);
  const SimulationResult exact = exact_of(p, budget);
  p.tolerance = tolerance;
  const ClosedContacts closed = closed_contacts(p);
  p.steps_per_tc = fewest_steps;
  while (p.steps_per_tc < max_steps && !is_stable(closed, p.integrator, 1.0 / p.steps_per_tc)) p.steps_per_tc *= 1.25;

  const auto with_growth = [&](SimulationResult c) {
    c.predicted_growth = predicted_growth(closed, p.integrator, 1.0 / c.steps_used);
    return c;
  };
  SimulationResult best;
  best.status = Status::unstable;
  best.steps_used = p.steps_per_tc;
  for (double factor = 1.0; p.steps_per_tc <= max_steps; p.steps_per_tc *= factor) {
    SimulationResult c = compared(stepped(p, max_work, budget), exact);
    c.steps_used = p.steps_per_tc;
    const bool is_better = is_success(c.status) && !(c.eps_eff_error >= best.eps_eff_error);
    if (is_better || !is_success(best.status)) best = c;
    if (best.eps_eff_error <= tolerance) return with_growth(best);
    const bool goes_on = is_success(c.status) || c.status == Status::unstable;
    if (!goes_on || !(exact.eps_eff_error < tolerance)) break;
    factor = is_success(c.status) ? std::clamp(margin * c.eps_eff_error / tolerance, least_factor, max_factor)
                                  : least_factor;
  }
  if (is_success(best.status)) best.status = Status::tolerance_missed;
  return with_growth(best);
}

}  // namespace

SimulationResult simulate_fixed_step(const Parameters& parameters, ComputeBudget* budget) {
  if (parameters.steps_per_tc > 0.0) return with_given_steps(parameters, budget);
  return with_chosen_steps(parameters, budget);
}

double steps_taken(const Parameters& parameters) {
  return parameters.steps_per_tc > 0.0 ? parameters.steps_per_tc : with_chosen_steps(parameters, nullptr).steps_used;
}

}  // namespace sigmasweep
