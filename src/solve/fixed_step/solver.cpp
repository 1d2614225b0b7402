#include <algorithm>

#include "solve/cost_model.hpp"
#include "solve/fixed_step/collision.hpp"
#include "solve/fixed_step/column/observed_collision.hpp"
#include "solve/fixed_step/lattice/observed_collision.hpp"
#include "solve/fixed_step/scheme_info.hpp"
#include "solve/fixed_step/vibrated.hpp"
#include "solve/observer/film_duration.hpp"
#include "solve/observer/record_column.hpp"
#include "solve/observer/record_lattice.hpp"
#include "solve/solvers.hpp"

/// Entries of the solvers by schemes of fixed time step.
namespace sigmasweep {
namespace {

bool accepts_column(const Parameters& p) { return p.method == Method::md && p.integrator != Integrator::exact; }
bool accepts_lattice(const Parameters& p) { return p.integrator != Integrator::exact; }

/// Steps a tc. The error of the schemes is about 0.03/steps_per_tc. Trials with longer steps cost little beside the
/// last.
double steps_of(const Parameters& p) {
  return p.steps_per_tc > 0.0 ? p.steps_per_tc : std::clamp(0.03 / p.tolerance, 20.0, 1e6);
}

/// Free flight is not stepped through: the duration is that of the wave and of the later contacts, tc each. Of N
/// contacts in a time sigma, N/(1 + sigma) last at the same time. The exact solution comes with it: the error is
/// measured against that.
double seconds_of_column(const Parameters& p) {
  constexpr double wave = 1.5;  // tc a bead; t_k is about N tc
  Parameters exact = p;
  exact.integrator = Integrator::exact;
  const double N = static_cast<double>(p.N);
  const double sigma = cost::bounded_sigma(p), at_once = 1.0 + N / (1.0 + sigma);
  const double duration = wave * N + cost::later_contacts(N, sigma) / at_once;
  const StepCost scheme = scheme_info(p.integrator).cost;
  return solver_of(exact).predicted_seconds(exact) + steps_of(p) * duration * (scheme.step + scheme.bead * N);
}

/// Steps are not skipped, and take three times as long as those of a collision, with the account of energy that is
/// kept.
double seconds_of_column_on_plate(const Parameters& p) {
  const StepCost scheme = scheme_info(p.integrator).cost;
  return cost::tuple + 3.0 * (scheme.step + scheme.bead * static_cast<double>(p.N)) * p.steps_per_tc *
                           static_cast<double>(p.periods) / (p.frequency * p.tc);
}

/// Of the steps in one tc.
double seconds_of_lattice_tc(const Parameters& p) {
  constexpr double bead = 40e-9;  // s; each bead and evaluation of the forces
  return bead * static_cast<double>(p.N) * scheme_info(p.integrator).evaluations * steps_of(p);
}

double seconds_of_lattice(const Parameters& p) {
  constexpr double wave_row = 3.0;  // duration of the wave in tc, each row
  constexpr double least = 30.0;    // duration in tc, beside the wave and the quiet time at the end, 2 N sigma
  const double duration =
      wave_row * static_cast<double>(p.rows) + 2.0 * static_cast<double>(p.N) * cost::bounded_sigma(p) + least;
  return cost::tuple + (cost::of_lattice_events(p) + seconds_of_lattice_tc(p) * duration);
}

double seconds_of_lattice_on_plate(const Parameters& p) {
  return cost::tuple + seconds_of_lattice_tc(p) * static_cast<double>(p.periods) / (p.frequency * p.tc);
}

void observe_column(const Parameters& p, const Column<double>& column, Samples& samples) {
  observe_fixed_step(column, p.integrator, 1.0 / steps_taken(p), samples);
}

void observe_lattice(const Parameters& p, const Lattice<double>& lattice, LatticeSamples& samples) {
  observe_fixed_step_lattice(lattice, p.integrator, 1.0 / steps_taken(p), samples);
}

}  // namespace

const Solver fixed_step_column{
    .name = "fixed step",
    .assembly = Assembly::column,
    .ground = GroundKind::wall,
    .accepts = accepts_column,
    .run = simulate_fixed_step,
    .observe = [](const Parameters& p,
                  std::span<const double> times) { return record_from_start(p, times, observe_column); },
    .predicted_seconds = seconds_of_column,
    .film_duration = film_of_column,
};

const Solver fixed_step_column_on_plate{
    .name = "fixed step, on a plate",
    .assembly = Assembly::column,
    .ground = GroundKind::plate,
    .accepts = accepts_column,
    .run = fixed_step_column_run_on_plate,
    .observe = [](const Parameters& p,
                  std::span<const double> times) { return record_on_plate(p, times, observe_fixed_step_on_plate); },
    .predicted_seconds = seconds_of_column_on_plate,
    .film_duration = film_on_plate,
};

const Solver fixed_step_lattice{
    .name = "fixed step, lattice",
    .assembly = Assembly::lattice,
    .ground = GroundKind::wall,
    .accepts = accepts_lattice,
    .run = simulate_fixed_step,
    .observe = [](const Parameters& p,
                  std::span<const double> times) { return record_lattice(p, times, observe_lattice); },
    .predicted_seconds = seconds_of_lattice,
    .film_duration = film_of_lattice,
};

const Solver fixed_step_lattice_on_plate{
    .name = "fixed step, lattice, on a plate",
    .assembly = Assembly::lattice,
    .ground = GroundKind::plate,
    .accepts = accepts_lattice,
    .run = fixed_step_lattice_run_on_plate,
    .observe =
        [](const Parameters& p, std::span<const double> times) {
          return record_lattice_on_plate(p, times, observe_fixed_step_lattice_on_plate);
        },
    .predicted_seconds = seconds_of_lattice_on_plate,
    .film_duration = film_on_plate,
};

}  // namespace sigmasweep
