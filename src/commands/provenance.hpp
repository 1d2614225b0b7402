#pragma once

#include <string>

/// Where and when a result was made.
namespace sigmasweep {

std::string host_name();
/// ISO 8601, UTC.
std::string utc_now();

}  // namespace sigmasweep
