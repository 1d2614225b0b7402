#include "solve/fixed_step/column/vibrated.hpp"

#include <cmath>

#include "solve/fixed_step/column/run.hpp"
#include "solve/fixed_step/plate_course.hpp"

namespace sigmasweep {

Outcome<double> fixed_step_vibrated_column(const Column<double>& column, const Plate& plate, Integrator integrator,
                                           double dt, VibrationStatistics& statistics, ComputeBudget* budget) {
  const double steps = std::ceil(plate.period() / dt);
  return run_column(column, plate, integrator, plate.period() / steps, PlateCourse(plate, steps), {.budget = budget},
                    {}, statistics);
}

}  // namespace sigmasweep
