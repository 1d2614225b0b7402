#pragma once

#include "solve/fixed_step/dispatch.hpp"
#include "solve/fixed_step/driver.hpp"
#include "solve/fixed_step/lattice/system.hpp"

namespace sigmasweep {

/// Runs a lattice by fixed steps of `dt` through the course, with the kernels of its law and of the integrator.
template <class Ground, class Course, class Observer>
LatticeOutcome<double> run_lattice(const Lattice<double>& lattice, const Ground& ground, Integrator integrator,
                                   double dt, Course course, const RunLimits& limits, const StepOptions& options,
                                   Observer& observer) {
  return with_law_and_scheme(lattice.beads, integrator, [&]<class Force, bool Uneven, class Scheme>() {
    using System = LatticeSystem<Force, Uneven, Scheme, Ground>;
    System system(lattice, dt, ground);
    return FixedStepDriver<System, Course, Observer>(system, course, limits, options, observer)();
  });
}

}  // namespace sigmasweep
