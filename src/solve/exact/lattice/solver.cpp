#include "solve/cost_model.hpp"
#include "solve/exact/lattice/collision.hpp"
#include "solve/exact/lattice/vibrated.hpp"
#include "solve/observer/film_duration.hpp"
#include "solve/observer/record_lattice.hpp"
#include "solve/solvers.hpp"

/// Entries of the solvers that move lattices from event to event.
namespace sigmasweep {
namespace {

bool accepts(const Parameters& p) { return p.integrator == Integrator::exact; }

double seconds_on_plate(const Parameters& p) {
  constexpr double bead_period = 0.4e-3;  // s; each bead and period of the plate
  return cost::tuple + static_cast<double>(p.N) * (bead_period * static_cast<double>(p.periods));
}

}  // namespace

const Solver lattice_events{
    .name = "exact, lattice",
    .assembly = Assembly::lattice,
    .ground = GroundKind::wall,
    .accepts = accepts,
    .run = simulate_lattice,
    .observe =
        [](const Parameters& p, std::span<const double> times) {
          return record_lattice(p, times,
                                [](const Parameters&, const Lattice<double>& lattice, LatticeSamples& samples) {
                                  observe_lattice(lattice, samples);
                                });
        },
    .predicted_seconds = [](const Parameters& p) { return cost::tuple + cost::of_lattice_events(p); },
    .film_duration = film_of_lattice,
};

const Solver lattice_events_on_plate{
    .name = "exact, lattice, on a plate",
    .assembly = Assembly::lattice,
    .ground = GroundKind::plate,
    .accepts = accepts,
    .run = simulate_lattice_on_plate,
    .observe =
        [](const Parameters& p, std::span<const double> times) {
          return record_lattice_on_plate(p, times, observe_lattice_on_plate);
        },
    .predicted_seconds = seconds_on_plate,
    .film_duration = film_on_plate,
};

}  // namespace sigmasweep
