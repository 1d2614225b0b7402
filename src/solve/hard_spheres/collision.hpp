#pragma once

#include "assembly/column.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

/// Event-driven hard spheres (ED): instant collisions, free flight in between. Collisions at the same time go by the
/// largest-relative-velocity rule (LRV): of all touching pairs that approach, the fastest is next.
namespace sigmasweep {

class Samples;

struct HardSphereSettings {
  EdRule rule = EdRule::lrv;     ///< energy loss of a collision
  bool predict_collapse = true;  ///< finish a collapse of equal beads as soon as it is certain; for tests
  /// Times closer than this, relative, are the same time: equal gaps and matched restitutions make exactly simultaneous
  /// collisions, which rounding pulls apart by about 1e-16 a collision of the bead.
  double same_time = 1e-12;
  /// A pair that collides again in next to no time, and by now is slower than this (units v0), will do so for ever:
  /// inelastic collapse.
  double collapsed_speed = 1e-16;
};

/// One collision of the column with its restitutions eps and eps_wall; K and C play no role. In units of the gap and
/// the speed the result of EdRule::lrv depends on N, the restitutions, mass and gap ratios only, so that is how it is
/// computed: to the last bit it is the same for every gap > 0 and every speed. Status::ok; collapsed; event_limit, with
/// the velocities so far. Limit of its own: 1e7 + 10 N^2 collisions, but at most 2e8.
///
/// With EdRule::tc a collision is elastic, also at the wall, if one of the two beads has collided less than column.tc
/// ago; the wall has no clock of its own. There is no inelastic collapse then. Of a column that starts in touch
/// (gap = 0) all collisions are at time zero, in the order of the LRV rule: the first one, bead 1 and the wall, loses
/// energy, the others, zero time later, do not; that is also the limit of small gaps.
Outcome<double> hard_sphere_collision(const Column<double>& column, const HardSphereSettings& settings = {},
                                      const RunLimits& limits = {});

/// The tuple's collision. eps_eff_error: what the result changes by when eps, and masses and gaps that are not all the
/// same, change in their last bits (that shows the condition of the problem) and same_time changes, a bound on the
/// rounding of the collisions, and what is left to dissipate at the end.
SimulationResult simulate_hard_spheres(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The run seen by the samples, and over with the last of them. The clock starts with the fall. Units: the gap and the
/// speed; where there is no gap, any length.
void observe_hard_spheres(const Column<double>& column, EdRule rule, Samples& samples);

}  // namespace sigmasweep
