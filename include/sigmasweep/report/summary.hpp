#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/row.hpp"

namespace sigmasweep {

/// The largest spread of eps_eff among rows that should be the same point: equal sigma (to 1e-12, relative), N,
/// epsilon, method, wall and integrator, but other v0, tc or s0. How universal the curve is.
struct Universality {
  double spread = 0.0;       ///< largest max - min of eps_eff within a group
  double sigma = 0.0;        ///< where
  std::uint64_t groups = 0;  ///< groups of at least two rows
};
Universality universality(std::span<const Row> rows);

/// What the sweep ends with: rows by status, quantiles of error and run time, makespan against its lower bound
/// max(sum/ranks, longest), universality. `wall_seconds` is the time the computing took, 0 when nothing was computed.
std::string summary(std::span<const Row> rows, int ranks, double wall_seconds);

}  // namespace sigmasweep
