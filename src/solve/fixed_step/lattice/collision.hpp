#pragma once

#include <cstdint>

#include "assembly/lattice.hpp"

namespace sigmasweep {

/// Free flight is crossed in one go, by a whole number of steps; or, for tests, step by step.
enum class FreeFlight : std::uint8_t { skipped, stepped };

LatticeOutcome<double> fixed_step_lattice_collision(const Lattice<double>& lattice, Integrator integrator, double dt,
                                                    const LatticeOptions& options, FreeFlight free_flight);

}  // namespace sigmasweep
