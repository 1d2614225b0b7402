#pragma once

#include "sigmasweep/sweep/row.hpp"

namespace sigmasweep {

/// One row of a sweep: simulate(), with its predicted time and the CPU time of this thread. Whatever the solver throws
/// becomes Status::failed.
Row compute_row(const Tuple& tuple, int rank) noexcept;

}  // namespace sigmasweep
