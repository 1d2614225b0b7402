#pragma once

#include "assembly/lattice.hpp"

namespace sigmasweep {

class LatticeSamples;

/// The lattice's collision seen by the samples, and over with the last of them. The clock starts with the fall.
void observe_lattice(const Lattice<double>& lattice, LatticeSamples& samples);

}  // namespace sigmasweep
