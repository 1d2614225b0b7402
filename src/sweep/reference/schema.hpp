#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The JSON schema (draft 07) of a spec that may have the tables `sections` beside the sweep's own. Editors complete
/// and check specs by it. It knows keys, types and names; relations between keys are checked when a spec is read.
std::string spec_schema(std::span<const SpecSection> sections);

}  // namespace sigmasweep
