#pragma once

#include "solve/fixed_step/column/system.hpp"
#include "solve/fixed_step/dispatch.hpp"
#include "solve/fixed_step/driver.hpp"

namespace sigmasweep {

/// Runs a column by fixed steps of `dt` through the course, with the kernels of its law and of the integrator.
template <class Ground, class Course, class Observer>
Outcome<double> run_column(const Column<double>& column, const Ground& ground, Integrator integrator, double dt,
                           Course course, const RunLimits& limits, const StepOptions& options, Observer& observer) {
  return with_law_and_scheme(column, integrator, [&]<class Force, bool Uneven, class Scheme>() {
    using System = ColumnSystem<Force, Uneven, Scheme, Ground>;
    System system(column, dt, ground);
    return FixedStepDriver<System, Course, Observer>(system, course, limits, options, observer)();
  });
}

}  // namespace sigmasweep
