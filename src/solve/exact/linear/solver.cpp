#include "sigmasweep/model/law.hpp"
#include "solve/cost_model.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/linear/many.hpp"
#include "solve/exact/linear/side_by_side/batch.hpp"
#include "solve/exact/linear/vibrated.hpp"
#include "solve/observer/film_duration.hpp"
#include "solve/observer/record_column.hpp"
#include "solve/solvers.hpp"

/// Entries of the solvers that propagate columns under the linear law exactly between contact events.
namespace sigmasweep {
namespace {

bool accepts(const Parameters& p) {
  return p.method == Method::md && p.integrator == Integrator::exact && exponents(p).linear();
}

constexpr cost::EventCosts event_costs{
    .dense_bead = 0.6e-6, .dense_pair = 0.35e-6, .contact = 0.2e-6, .shared_contact = 40e-9};
/// Of columns side by side.
constexpr cost::EventCosts lane_costs{
    .dense_bead = 0.35e-6, .dense_pair = 45e-9, .contact = 30e-9, .shared_contact = 12e-9};
constexpr double contact_on_plate = 9e-6;  // s

}  // namespace

const Solver linear_column{
    .name = "exact, linear law",
    .assembly = Assembly::column,
    .ground = GroundKind::wall,
    .accepts = accepts,
    .run = simulate_linear,
    .observe =
        [](const Parameters& p, std::span<const double> times) {
          return record_from_first_contact(p, times,
                                           [](const Parameters&, const Column<double>& column, Samples& samples) {
                                             observe_exact(column, samples);
                                           });
        },
    .predicted_seconds =
        [](const Parameters& p) { return cost::of_collision(p, goes_side_by_side(p) ? lane_costs : event_costs); },
    .film_duration = film_of_column,
    .run_many = simulate_linear_many,
};

const Solver linear_column_on_plate{
    .name = "exact, linear law, on a plate",
    .assembly = Assembly::column,
    .ground = GroundKind::plate,
    .accepts = accepts,
    .run = simulate_exact_on_plate,
    .observe = [](const Parameters& p,
                  std::span<const double> times) { return record_on_plate(p, times, observe_exact_on_plate); },
    .predicted_seconds = [](const Parameters& p) { return cost::of_periods(p, contact_on_plate); },
    .film_duration = film_on_plate,
};

}  // namespace sigmasweep
