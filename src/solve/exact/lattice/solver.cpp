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

/// Times the time of two runs of the first accuracy: measured at epsilon 0.6 and 0.9, sigma 0.003 to 30, 4 to 16 rows.
/// Small tolerances need finer runs; irregular lattices that are large, or whose beads meet one by one, need them in
/// wide types. What is chaotic gives up sooner than this says.
double refinement(const Parameters& p) {
  constexpr double loose = 1e-8, once = 0.8, again = 2.7, in_wide_types = 12.0;
  constexpr std::int64_t large = 10;  // rows
  if (p.tolerance > loose) return once;
  const bool is_irregular = p.random_separation == Flag::yes || p.width > 0.0;
  return is_irregular && (p.rows >= large || p.sigma >= 1.0) ? again * in_wide_types : again;
}

double seconds_to_wall(const Parameters& p) { return cost::tuple + refinement(p) * cost::of_lattice_events(p); }

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
    .predicted_seconds = seconds_to_wall,
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
