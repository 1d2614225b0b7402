#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/report/row_source.hpp"

namespace sigmasweep {

/// The largest spread of eps_eff among rows that should be the same point: equal sigma (to 1e-12, relative), N,
/// epsilon, method, wall and integrator with its accuracy (steps_per_tc or tolerance), but other v0, tc or s0. How
/// universal the curve is. Rows without a result are ignored. Of more
/// than four million rows nothing is said.
struct Universality {
  double spread = 0.0;       ///< largest max - min of eps_eff within a group
  double sigma = 0.0;        ///< where
  std::uint64_t groups = 0;  ///< groups of at least two rows
};
Universality universality(const RowSource& rows);

/// The computing that was done in one run (a run that goes on with an earlier one computes only some of the rows).
struct Work {
  std::uint64_t rows = 0;
  double cpu_seconds = 0.0, longest_seconds = 0.0;
  double computing_seconds = 0.0;  ///< time by the clock that all ranks together spent on rows; 0: not known
  void add(double run_time);       ///< of a row, s
};

/// The smallest value that half of the rows, 90 %, 99 % and all of them do not exceed, of the field `name`; rows
/// without a value do not count.
struct Quantiles {
  std::string name;
  std::array<double, 4> values{};
};
/// What the rows come to, counted in one pass over them.
struct Overview {
  /// How many rows have each status, of those that occur, in the order of their numbers.
  std::vector<std::pair<std::string_view, std::uint64_t>> by_status{};
  std::uint64_t failed = 0;  ///< rows that have no result
  /// Of eps_eff_error, h_cm_error, |imbalance| and run_time (s), where rows have them.
  std::vector<Quantiles> quantiles{};
};
Overview overview(const RowSource& rows);

/// max(sum/ranks, longest), s: no schedule of the work ends earlier.
double least_seconds(const Work& work, int ranks);

/// The text at the end of a sweep: rows by status, quantiles of error and run time, makespan against its lower bound
/// max(sum/ranks, longest) and what was lost to the schedule and to a busy machine, universality. `wall_seconds` is the
/// time that the computing of `work` took on `ranks` ranks, 0 when nothing was computed. `seen` is the overview().
std::string summary(const RowSource& rows, const Overview& seen, const Work& work, int ranks, double wall_seconds);
std::string summary(const RowSource& rows, const Work& work, int ranks, double wall_seconds);
/// The same when all rows were computed in that time.
std::string summary(const RowSource& rows, int ranks, double wall_seconds);

}  // namespace sigmasweep
