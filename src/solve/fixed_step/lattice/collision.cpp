#include "solve/fixed_step/lattice/collision.hpp"

#include "assembly/ground.hpp"
#include "solve/fixed_step/collision_course.hpp"
#include "solve/fixed_step/lattice/ending.hpp"
#include "solve/fixed_step/lattice/run.hpp"
#include "solve/observer/samples.hpp"

namespace sigmasweep {

LatticeOutcome<double> fixed_step_lattice_collision(const Lattice<double>& lattice, Integrator integrator, double dt,
                                                    const RunLimits& limits, const StepOptions& options) {
  NullObserver nobody;
  return run_lattice(lattice, FixedWall{}, integrator, dt, CollisionCourse(LatticeEnding(lattice, dt, limits.settle)),
                     limits, options, nobody);
}

}  // namespace sigmasweep
