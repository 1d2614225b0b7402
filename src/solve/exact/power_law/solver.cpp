#include "sigmasweep/model/law.hpp"
#include "solve/cost_model.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "solve/exact/power_law/vibrated.hpp"
#include "solve/observer/film_duration.hpp"
#include "solve/observer/record_column.hpp"
#include "solve/solvers.hpp"

/// Entries of the solvers that integrate columns under laws that are not linear from contact event to contact event.
namespace sigmasweep {
namespace {

bool accepts(const Parameters& p) {
  return p.method == Method::md && p.integrator == Integrator::exact && !exponents(p).linear();
}

constexpr cost::EventCosts event_costs{
    .dense_bead = 100e-6, .dense_pair = 8e-6, .contact = 70e-6, .shared_contact = 1e-6};

/// Where gaps are wide nearly all contacts are isolated, and cost a look into a table. It is not for the finest runs.
double seconds(const Parameters& p) {
  constexpr double isolated_contact = 0.5e-6, wide = 0.5, finest = 1e-10;  // s; sigma over N; tolerance
  const double N = static_cast<double>(p.N);
  if (p.sigma > wide * N && p.tolerance >= finest) return cost::tuple + isolated_contact * N * N;
  return cost::of_collision(p, event_costs);
}

constexpr double contact_on_plate = 550e-6;  // s

}  // namespace

const Solver power_law_column{
    .name = "exact, power law",
    .assembly = Assembly::column,
    .ground = GroundKind::wall,
    .accepts = accepts,
    .run = simulate_nonlinear,
    .observe =
        [](const Parameters& p, std::span<const double> times) {
          return record_from_first_contact(p, times,
                                           [](const Parameters&, const Column<double>& column, Samples& samples) {
                                             observe_nonlinear(column, samples);
                                           });
        },
    .predicted_seconds = seconds,
    .film_duration = film_of_column,
};

const Solver power_law_column_on_plate{
    .name = "exact, power law, on a plate",
    .assembly = Assembly::column,
    .ground = GroundKind::plate,
    .accepts = accepts,
    .run = simulate_nonlinear_on_plate,
    .observe = [](const Parameters& p,
                  std::span<const double> times) { return record_on_plate(p, times, observe_nonlinear_on_plate); },
    .predicted_seconds = [](const Parameters& p) { return cost::of_periods(p, contact_on_plate); },
    .film_duration = film_on_plate,
};

}  // namespace sigmasweep
