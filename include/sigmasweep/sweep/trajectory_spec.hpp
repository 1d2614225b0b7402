#pragma once

#include <cstdint>
#include <vector>

namespace sigmasweep {

/// The table [trajectory] of a spec: rows whose trajectories are recorded, each into a file beside the table.
///
///     samples  = 1001      # evenly spaced, both ends included; 2 to 1,000,000, at most 2^26 coordinates in all
///     duration = 2e-4      # s from the start; default: show_time(), for most collisions 1.5 times the time to the
///                          # last contact with the wall, for a plate 10 periods
///     where    = "N == 10" # condition on the parameters of the rows; default: all rows
struct TrajectorySpec {
  static constexpr std::uint64_t max_files = 10'000;
  std::uint64_t samples = 1001;
  double duration = 0.0;            ///< s; 0: show_time() of each row
  std::vector<std::uint64_t> rows;  ///< at most max_files
};

}  // namespace sigmasweep
