#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// One row of a sweep to compute, with its predicted CPU time, s. A plain value of fixed size: it is sent between
/// ranks.
struct SweepTask {
  std::uint64_t index = 0;
  double predicted_seconds = 0.0;
  Parameters parameters;
};

/// Computes one row: simulate(), with the CPU time of this thread. Whatever a solver throws becomes Status::failed. A
/// row that takes longer than `limit` of CPU time, s, becomes Status::time_limit; by default the limit is
/// default_time_limit(). Nothing comes back if the row took long and `should_end` said that it is to end.
std::optional<Row> compute_row(const SweepTask& task, int rank, std::optional<double> limit = {},
                               std::function<bool()> should_end = {}) noexcept;

/// A hundred times the predicted time, but at least a minute, s.
double default_time_limit(double predicted_seconds);

}  // namespace sigmasweep
