#pragma once

#include <functional>
#include <optional>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// One row of a sweep: simulate(), with its predicted time and the CPU time of this thread. Whatever the solver throws
/// becomes Status::failed. Status::time_limit after
/// `limit` of CPU time, s; by default time_limit_of(). Nothing if it took long and `to_end` said that it is to end.
std::optional<Row> compute_row(const Tuple& tuple, int rank, std::optional<double> limit = {},
                               std::function<bool()> to_end = {}) noexcept;

/// A hundred times what is predicted, but at least a minute, s.
double time_limit_of(const Parameters& parameters);

}  // namespace sigmasweep
