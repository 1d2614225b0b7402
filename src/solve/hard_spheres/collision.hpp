#pragma once

#include <optional>

#include "assembly/column.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

/// Event-driven hard spheres (ED): instant collisions with free flight between them. Simultaneous collisions follow the
/// largest-relative-velocity rule (LRV): the fastest of all touching pairs that approach collides next.
namespace sigmasweep {

class Samples;

struct HardSphereSettings {
  EdRule rule = EdRule::lrv;     ///< the collisions that dissipate energy
  bool predict_collapse = true;  ///< finish a collapse of equal beads as soon as it is certain; for tests
  /// Largest relative difference of simultaneous times. Equal gaps and matched restitutions make exactly simultaneous
  /// collisions, which rounding separates by about 1e-16 for each collision of the bead.
  double same_time = 1e-12;
  /// Largest speed, in v0, of an inelastic collapse: a pair that collides again almost at once and more slowly will do
  /// so infinitely often.
  double collapsed_speed = 1e-16;
  bool remember_hits = false;  ///< what has collapsed and is hit again is not computed again
};

/// Computes the collision of the column with its restitutions eps and eps_wall; K and C are not used. Units are the gap
/// and the speed, in which the result of EdRule::lrv depends on N, restitutions, mass and gap ratios only. It is the
/// same to the bit for every gap > 0 and every speed. Status: ok; collapsed; event_limit, with the velocities so far.
/// The solver's own limit is 1e7 + 10 N^2 collisions, but at most 2e8.
///
/// With EdRule::tc a collision, also with the wall, is elastic if one of the beads has collided less than column.tc
/// ago. There is no inelastic collapse then. In a column that starts in touch (gap = 0) all collisions are at time
/// zero, in the order of the LRV rule. The first one, of bead 1 and the wall, dissipates energy; the others do not.
/// This is also the limit of small gaps.
Outcome<double> hard_sphere_collision(const Column<double>& column, const HardSphereSettings& settings = {},
                                      const RunLimits& limits = {});

/// Computes the tuple's collision. eps_eff_error is the sum of the change of the result by changes of eps, unequal
/// masses and gaps in their last bits and of same_time; a bound of the rounding errors of collisions; the dissipation
/// that is possible after the end; and the error by the finite resolution of time.
SimulationResult simulate_hard_spheres(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// A result, and its t_k in units of the gap, or of any length if that is 0, over the speed.
struct HardSphereResult {
  SimulationResult result;
  double t_k;
};
/// The same where doubles meet the tolerance and the collisions are not too many.
std::optional<HardSphereResult> short_hard_sphere_run(const Parameters& parameters);

/// Computes the collision until the last sample is taken. Time counts from the start of the fall. Units are the gap, or
/// without a gap any length, and the speed.
void observe_hard_spheres(const Column<double>& column, EdRule rule, Samples& samples);

}  // namespace sigmasweep
