#include "solve/fixed_step/column/collision.hpp"

#include "assembly/ground.hpp"
#include "solve/fixed_step/collision_course.hpp"
#include "solve/fixed_step/column/ending.hpp"
#include "solve/fixed_step/column/run.hpp"
#include "solve/observer/samples.hpp"

namespace sigmasweep {

Outcome<double> fixed_step_collision(const Column<double>& column, Integrator integrator, double dt,
                                     const RunLimits& limits, const StepOptions& options) {
  NullObserver nobody;
  return run_column(column, FixedWall{}, integrator, dt, CollisionCourse(ColumnEnding(limits.settle)), limits, options,
                    nobody);
}

}  // namespace sigmasweep
