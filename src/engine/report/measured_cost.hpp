#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// How the predicted times of a sweep compare with the times that some of its rows take.
struct MeasuredCost {
  std::vector<double> ratios;       ///< needed over predicted time, ascending
  double mean = 1.0;                ///< of the ratios: what the sum of all predicted times must be multiplied with
  double standard_error = 0.0;      ///< of the mean; NaN for one row
  double longest_seconds = 0.0;     ///< the longest time that a row needed
  std::uint64_t given_up = 0;       ///< rows that took longer than the limit, which counts as their time
  double quantile(double q) const;  ///< the smallest ratio that the part q of them does not exceed
};

/// Computes `count` rows, on this thread. The tasks are put in order of predicted time, and divided into parts of equal
/// predicted time; a row of each part is computed. So rows count by the time that they are predicted to take, and the
/// mean of the ratios is an estimate of the ratio of the sums without bias. The choice depends on the tasks only. Rows
/// that a run computes side by side are computed with some of their neighbours. A row is given up after `limit`, s.
MeasuredCost measure_cost(const Sweep& sweep, std::vector<ScheduledTask> tasks, std::size_t count, double limit = 60.0);

}  // namespace sigmasweep
