#pragma once

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/lattice_statistics.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// A lattice in a container that vibrates as a whole under gravity, at rest relative to it at the start, as given; by
/// steps of at most `dt`, as fixed_step_vibrated_column(). Work in is the container's: all of its walls move.
LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, LatticeStatistics& statistics,
                                                   ComputeBudget* budget = nullptr);
/// The same with samples of the motion (vibrated_samples.cpp).
LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, VibratedLatticeSamples& samples,
                                                   ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
