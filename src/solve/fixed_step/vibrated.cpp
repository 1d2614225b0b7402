#include "solve/fixed_step/vibrated.hpp"

#include "solve/fixed_step/column/vibrated.hpp"
#include "solve/fixed_step/lattice/vibrated.hpp"
#include "solve/fixed_step/stability.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/samples.hpp"
#include "solve/run_on_plate.hpp"

namespace sigmasweep {
namespace {

SimulationResult with_growth_and_steps(SimulationResult result, const Parameters& p) {
  result.predicted_growth = predicted_growth(p);
  result.steps_used = p.steps_per_tc;
  return result;
}

}  // namespace

SimulationResult fixed_step_column_run_on_plate(const Parameters& p, ComputeBudget* budget) {
  const auto follow = [&](const Column<double>& column, const Plate& plate, VibrationStatistics& statistics) {
    return fixed_step_vibrated_column(column, plate, p.integrator, 1.0 / p.steps_per_tc, statistics, budget);
  };
  return with_growth_and_steps(run_column_on_plate(p, MotionBetween::steps, follow), p);
}

SimulationResult fixed_step_lattice_run_on_plate(const Parameters& p, ComputeBudget* budget) {
  const auto follow = [&](const Lattice<double>& lattice, const Plate& plate, LatticeStatistics& statistics) {
    return fixed_step_vibrated_lattice(lattice, plate, p.integrator, 1.0 / p.steps_per_tc, statistics, budget);
  };
  return with_growth_and_steps(run_lattice_on_plate(p, MotionBetween::steps, follow), p);
}

void observe_fixed_step_on_plate(const Parameters& p, VibratedSamples& samples) {
  fixed_step_vibrated_column(reduced_column<double>(p), Plate::of(p, vibration_units(p)), p.integrator,
                             1.0 / p.steps_per_tc, samples);
}

void observe_fixed_step_lattice_on_plate(const Parameters& p, VibratedLatticeSamples& samples) {
  fixed_step_vibrated_lattice(reduced_lattice<double>(p), Plate::of(p, vibration_units(p)), p.integrator,
                              1.0 / p.steps_per_tc, samples);
}

}  // namespace sigmasweep
