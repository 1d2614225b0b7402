#include "solve/cost_model.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "solve/hard_spheres/many.hpp"
#include "solve/hard_spheres/vibrated_column.hpp"
#include "solve/observer/film_duration.hpp"
#include "solve/observer/record_column.hpp"
#include "solve/solvers.hpp"

/// Entries of the event-driven solvers of hard spheres (ED).
namespace sigmasweep {
namespace {

bool accepts(const Parameters& p) { return p.method == Method::ed; }

double seconds(const Parameters& p) {
  constexpr double collision = 0.12e-6, collision_bead = 3e-9;  // s; a collision, and each bead of the column in it
  constexpr double tc_rule = 1.5;                               // times the rule lrv
  const double N = static_cast<double>(p.N);
  const double rule = p.ed_rule == EdRule::tc ? tc_rule : 1.0;
  return cost::tuple + rule * N * N * (collision + collision_bead * N);
}

constexpr double contact_on_plate = 2e-6;  // s

}  // namespace

const Solver hard_spheres{
    .name = "hard spheres",
    .assembly = Assembly::column,
    .ground = GroundKind::wall,
    .accepts = accepts,
    .run = simulate_hard_spheres,
    .observe =
        [](const Parameters& p, std::span<const double> times) {
          return record_in_gaps(p, times, [](const Parameters& tuple, const Column<double>& column, Samples& samples) {
            observe_hard_spheres(column, tuple.ed_rule, samples);
          });
        },
    .predicted_seconds = seconds,
    .film_duration = film_of_column,
    .run_many = simulate_hard_spheres_many,
};

const Solver hard_spheres_on_plate{
    .name = "hard spheres, on a plate",
    .assembly = Assembly::column,
    .ground = GroundKind::plate,
    .accepts = accepts,
    .run = simulate_vibrated_hard_spheres,
    .observe = [](const Parameters& p,
                  std::span<const double> times) { return record_on_plate(p, times, observe_vibrated_hard_spheres); },
    .predicted_seconds = [](const Parameters& p) { return cost::of_periods(p, contact_on_plate); },
    .film_duration = film_on_plate,
};

}  // namespace sigmasweep
