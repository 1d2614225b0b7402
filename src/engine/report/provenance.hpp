#pragma once

#include <string>

#include "sigmasweep/sweep/sweep.hpp"
#include "store/table/table.hpp"

/// Where and when a result was made.
namespace sigmasweep {

std::string host_name();
/// ISO 8601, UTC.
std::string utc_now();

/// What a table says of its sweep, and of a run of it that began at `start`, on so many ranks and this host.
TableInfo table_info(const Sweep& sweep, const std::string& start, int ranks);

}  // namespace sigmasweep
