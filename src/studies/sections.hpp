#pragma once

#include <array>

#include "studies/precision/spec.hpp"

namespace sigmasweep {

/// The tables of studies that a spec may have.
inline constexpr std::array study_sections{precision_section};

}  // namespace sigmasweep
