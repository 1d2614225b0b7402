#include "solve/fixed_step/lattice/vibrated.hpp"

#include <cmath>

#include "solve/fixed_step/lattice/run.hpp"
#include "solve/fixed_step/plate_course.hpp"

namespace sigmasweep {

LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, VibratedLatticeSamples& samples,
                                                   ComputeBudget* budget) {
  const double steps = std::ceil(plate.period() / dt);
  return run_lattice(lattice, plate, integrator, plate.period() / steps, PlateCourse(plate, steps), {.budget = budget},
                     {}, samples);
}

}  // namespace sigmasweep
