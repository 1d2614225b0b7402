#pragma once

#include <string>

#include "sigmasweep/sweep/sweep.hpp"
#include "store/table/table_info.hpp"

/// Where and when a result was made.
namespace sigmasweep {

std::string host_name();
/// The time now: ISO 8601, UTC.
std::string utc_now();

/// The root attributes of a table: its sweep, and a run that began at `start` on so many ranks and this host.
TableInfo table_info(const Sweep& sweep, const std::string& start, int ranks);

}  // namespace sigmasweep
