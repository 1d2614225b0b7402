#pragma once

#include <cstdint>

namespace sigmasweep {

/// Whether free flight is crossed at once, by a whole number of steps, or, for tests, step by step.
enum class FreeFlight : std::uint8_t { skipped, stepped };

/// Options of solvers with fixed steps, beside RunLimits.
struct StepOptions {
  FreeFlight free_flight = FreeFlight::skipped;
  std::uint64_t* steps = nullptr;  ///< if given: set to the number of steps made, skipped ones not counted
};

}  // namespace sigmasweep
