#pragma once

#include "engine/run.hpp"

namespace sigmasweep {

/// The options of the command `stability`.
struct StabilityOptions {
  RunOptions run;
  bool plots = true;
};

/// Runs the sweep as run() does, then prints and draws the map of stable steps; on all ranks. Returns the exit code of
/// run(), but unstable rows are not failures.
int stability_study(World& world, const StabilityOptions& options);

}  // namespace sigmasweep
