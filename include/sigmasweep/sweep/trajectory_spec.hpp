#pragma once

#include <cstdint>
#include <vector>

namespace sigmasweep {

/// [trajectory] of a spec: rows whose motions are filmed, into a file each beside the table.
///
///     samples  = 1001      # evenly spaced, both ends included; 2 to 1,000,000, at most 2^26 coordinates in all
///     duration = 2e-4      # s from the start; without it 1.5 times to the last contact with the wall, less of dilute
///                          # lattices, and of what vibrates 10 periods (show_time())
///     where    = "N == 10" # which rows: a condition on the parameters; without it all
struct TrajectorySpec {
  static constexpr std::uint64_t max_files = 10'000;
  std::uint64_t samples = 1001;
  double duration = 0.0;            ///< s; 0: show_time() of each row
  std::vector<std::uint64_t> rows;  ///< at most max_files
};

}  // namespace sigmasweep
