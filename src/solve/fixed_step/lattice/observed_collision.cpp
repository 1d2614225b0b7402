#include "solve/fixed_step/lattice/observed_collision.hpp"

#include "assembly/ground.hpp"
#include "solve/fixed_step/collision_course.hpp"
#include "solve/fixed_step/lattice/ending.hpp"
#include "solve/fixed_step/lattice/run.hpp"

namespace sigmasweep {

void observe_fixed_step_lattice(const Lattice<double>& lattice, Integrator integrator, double dt,
                                LatticeSamples& samples) {
  const RunLimits limits{.settle = 0.0};  // ends at the last sample
  run_lattice(lattice, FixedWall{}, integrator, dt, CollisionCourse(LatticeEnding(lattice, dt, limits.settle)), limits,
              {}, samples);
}

}  // namespace sigmasweep
