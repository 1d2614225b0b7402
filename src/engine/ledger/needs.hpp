#pragma once

#include <cstdint>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// What a run needs of the machine, beside computing time.
struct SweepNeeds {
  double manager_bytes = 0.0;   ///< memory of rank 0
  double rank_bytes = 0.0;      ///< memory of each other rank
  double disk_bytes = 0.0;      ///< journals and table, which are there together at the end
  double seconds_before = 0.0;  ///< from the start to the first row: MPI begins, times are predicted and sorted
};

/// The needs of a run of so many rows of the sweep.
SweepNeeds needs_of(const Sweep& sweep, std::uint64_t rows, int ranks);

/// Why this machine cannot run so many rows of the sweep; empty if it can.
std::string why_too_many(const Sweep& sweep, std::uint64_t rows);

}  // namespace sigmasweep
