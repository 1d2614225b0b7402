#pragma once

#include "engine/phases/compute.hpp"
#include "engine/phases/open.hpp"

namespace sigmasweep {

/// Last phase: prints the summary of the sweep. Returns the exit code of the run, success or some_rows_failed.
int report_rows(const World& world, const OpenSweep& open, const Computed& computed, const Reporter& reporter);

/// The same as a JSON document on standard output, also of a run that was stopped (`finished` is false): then the exit
/// code is stopped.
int report_as_json(const World& world, const OpenSweep& open, const Computed& computed, bool finished,
                   const Reporter& reporter);

}  // namespace sigmasweep
