#pragma once

#include <span>

#include "assembly/lattice.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/trajectory.hpp"
#include "solve/observer/lattice_samples.hpp"

/// Recording of lattices. The solvers' units are tc and v0 tc; the clock starts with the fall, or with the plate's
/// motion.
namespace sigmasweep {

using ObserveLattice = void (*)(const Parameters&, const Lattice<double>&, LatticeSamples&);
using ObserveVibratedLattice = void (*)(const Parameters&, VibratedLatticeSamples&);

Trajectory record_lattice(const Parameters& parameters, std::span<const double> times, ObserveLattice observe);
/// Displacements and velocities are relative to the plate.
Trajectory record_lattice_on_plate(const Parameters& parameters, std::span<const double> times,
                                   ObserveVibratedLattice observe);

}  // namespace sigmasweep
