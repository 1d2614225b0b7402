#pragma once

#include <cstdint>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// A point of a sweep: row `index` of the table (0-based, in the order of the spec) and the parameters that define it.
struct Tuple {
  std::uint64_t index = 0;
  Parameters parameters;
};

/// Everything about a row that may differ between two runs of the same sweep; stored apart from the results.
struct Timing {
  double run_time = 0.0;        ///< CPU time of the rank's thread spent on the tuple, s
  double predicted_time = 0.0;  ///< CPU time that the cost model predicted, s
  std::int32_t rank = -1;       ///< rank that computed it
  std::int32_t attempt = 0;     ///< 1 for the first try
};

/// One finished row. A plain value of fixed size: it is sent between ranks, journalled and stored as it is.
struct Row {
  std::uint64_t index = 0;
  Parameters parameters;
  SimulationResult result;
  Timing timing;
};

}  // namespace sigmasweep
