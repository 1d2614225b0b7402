#pragma once

#include <vector>

#include "sigmasweep/sweep/run_spec.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/key.hpp"

namespace sigmasweep::spec {

/// Reads the table [run]. Throws SpecError.
RunSpec read_run(const Entry& table);
std::vector<KeyInfo> keys_of_run();

}  // namespace sigmasweep::spec
