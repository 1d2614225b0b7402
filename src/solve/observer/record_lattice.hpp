#pragma once

#include <span>

#include "assembly/lattice.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/trajectory.hpp"
#include "solve/observer/lattice_samples.hpp"

/// Recording of lattices. The solvers' units are tc and v0 tc; time counts from the start of the fall, or of the
/// plate's motion.
namespace sigmasweep {

using ObserveLattice = void (*)(const Parameters&, const Lattice<double>&, LatticeSamples&);
using ObserveVibratedLattice = void (*)(const Parameters&, VibratedLatticeSamples&);

Trajectory record_lattice(const Parameters& parameters, std::span<const double> times, ObserveLattice observe);
/// The solvers' displacements and velocities are relative to the plate.
Trajectory record_lattice_on_plate(const Parameters& parameters, std::span<const double> times,
                                   ObserveVibratedLattice observe);

}  // namespace sigmasweep
