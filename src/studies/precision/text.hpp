#pragma once

#include <span>
#include <string>

#include "studies/precision/study.hpp"

namespace sigmasweep {

/// The study as text, scene by scene, each with a verdict: the fastest setting for some errors. `axes`: the names of
/// the parameters that tell scenes apart.
std::string precision_text(std::span<const PrecisionRow> rows, std::span<const std::string> axes);

}  // namespace sigmasweep
