#pragma once

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/spec/entry.hpp"

namespace sigmasweep::spec {

/// Reads the table [run]. Throws SpecError.
RunSpec read_run(const Entry& run);

}  // namespace sigmasweep::spec
