#pragma once

#include <vector>

#include "sweep/spec/tuples/axis.hpp"

namespace sigmasweep::spec {

/// Reads the key points: tuples as lines of comma-separated values under a line with the parameters' names. Lines that
/// begin with # are comments. The parameters are axes of equal length. Throws SpecError with line and column.
std::vector<Setting> read_points(const Entry& entry);

/// The first line of points that come from a file: "# points of FILE".
inline constexpr std::string_view from_file = "# points of ";

}  // namespace sigmasweep::spec
