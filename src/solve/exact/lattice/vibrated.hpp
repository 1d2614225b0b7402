#pragma once

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"

namespace sigmasweep {

/// fixed_step_vibrated_lattice() from event to event instead. The watcher keeps it going.
template <class Watcher>
LatticeOutcome<double> follow_lattice(const Lattice<double>& lattice, const Plate& plate, const LatticeOptions& options,
                                      Watcher& watcher);

}  // namespace sigmasweep
