#include <algorithm>
#include <numbers>

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

/// Of the collisions of a collapse, s; `lost` is N (1 - epsilon). Columns of N beads collapse from about pi N/(N + 1.6)
/// on, where epsilon = tan^2(pi/4 (1 - 1/N)): see collapse.toml. Close to that thousands of collisions are computed in
/// wide types. With more losses a few collisions decide that it is a collapse, and only long columns need many.
double seconds_of_collapse(double N, double lost) {
  constexpr double wide = 1.7e-6, narrow = 0.5e-6, narrow_close = 6e-6, longest = 1.5;  // s
  constexpr double close = 3.35, long_column = 15.0;                                    // N (1 - epsilon), beads
  const double threshold = std::numbers::pi * N / (N + 1.6), width = std::min(0.022 * N, 0.4);
  const double begun = std::clamp((lost - threshold + width) / (1.6 * width), 0.0, 1.0);
  const double wide_to = N < 5.5 ? N : std::max(close, close + 0.3 * (8.0 - N));
  if (lost <= wide_to) return std::min(wide * (N * N * N) * (lost * lost) * (begun * begun), longest);
  const double longer = std::max(N / long_column, 1.0), closer = close / lost;
  const double close_by =
      narrow_close * (longer * longer * longer * longer) * (closer * closer * closer * closer * closer);
  return std::min(N * N * (narrow + close_by), longest);
}

/// N (1 - epsilon), from 0 to N.
double lost(const Parameters& p) {
  return static_cast<double>(p.N) * (p.epsilon >= 0.0 && p.epsilon <= 1.0 ? 1.0 - p.epsilon : 0.0);
}

double seconds(const Parameters& p) {
  constexpr double collision = 0.05e-6, collision_bead = 2.5e-9;  // s; a collision, and each bead of the column in it
  constexpr double tc_rule = 2.0;                                 // times the rule lrv
  const double N = static_cast<double>(p.N);
  const double apart = N * N * (collision + collision_bead * N);
  if (p.ed_rule == EdRule::tc) return cost::tuple + tc_rule * apart;
  return cost::tuple + apart + seconds_of_collapse(N, lost(p));
}

/// Beads that collapse are a cluster that flies, rests and takes off as one most of the time.
double seconds_on_plate(const Parameters& p) {
  constexpr double period = 2.5e-6, pair = 0.07e-6, contact = 0.6e-6;  // s
  constexpr double clustered = 40e-6, clustered_from = 3.5;            // s a period, N (1 - epsilon)
  const double N = static_cast<double>(p.N), periods = static_cast<double>(p.periods);
  if (lost(p) > clustered_from) return cost::tuple + periods * clustered;
  return cost::tuple + periods * (period + pair * N * N) + contact * cost::contacts_on_plate(p);
}

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
    .predicted_seconds = seconds_on_plate,
    .film_duration = film_on_plate,
};

}  // namespace sigmasweep
