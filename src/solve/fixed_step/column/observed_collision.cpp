#include "solve/fixed_step/column/observed_collision.hpp"

#include "assembly/ground.hpp"
#include "solve/fixed_step/collision_course.hpp"
#include "solve/fixed_step/column/ending.hpp"
#include "solve/fixed_step/column/run.hpp"

namespace sigmasweep {

void observe_fixed_step(const Column<double>& column, Integrator integrator, double dt, Samples& samples) {
  const RunLimits limits{.settle = 0.0};  // ends at the last sample
  run_column(column, FixedWall{}, integrator, dt, CollisionCourse(ColumnEnding(limits.settle)), limits, {}, samples);
}

}  // namespace sigmasweep
