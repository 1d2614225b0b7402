#pragma once

#include <cstdint>

#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/solve/column.hpp"

/// Event-driven hard spheres (ED): instant collisions, free flight in between. Collisions at the same time go by the
/// largest-relative-velocity rule (LRV): of all touching pairs that approach, the fastest is next.
namespace sigmasweep {

struct HardSphereOptions {
  double settle = 1e-13;              ///< stop once later collisions can change eps_eff by less than this; 0: never
  std::uint64_t collision_limit = 0;  ///< 0: 1e7 + 10 N^2, but at most 2e8
  bool foresee_collapse = true;       ///< finish an inelastic collapse as soon as it is certain; for tests
};

/// One collision of the column with its restitutions eps and eps_wall; tc, K and C play no role. In units of the gap
/// and the speed the result depends on N and the restitutions only, so that is how it is computed: to the last bit it
/// is the same for every gap > 0 and every speed. Status::ok; collapsed; event_limit, with the velocities so far.
Outcome<double> hard_sphere_collision(const Column<double>& column, const HardSphereOptions& options = {});

/// The tuple's collision. eps_eff_error: what the result changes by when eps changes in its last bits (that shows the
/// condition of the problem), a bound on the rounding of the collisions, and what is left to dissipate at the end.
Collision simulate_hard_spheres(const Parameters& parameters);

}  // namespace sigmasweep
