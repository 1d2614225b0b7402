#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "solve/exact/linear/resting/resting_cluster.hpp"

namespace sigmasweep {

/// Finds the steps in which the lowest beads of a column lie still on the plate, and keeps what these need: the modes
/// of n beads, made once for each n.
class RestingBeads {
 public:
  /// Number of beads up to which their modes are worth finding: that takes a hundredth of a second, or tenths of a
  /// second where masses differ.
  static constexpr std::size_t max_beads(bool has_unequal_masses) { return has_unequal_masses ? 32 : 100; }

  /// Whether it is too early to try again. To be asked once before each try.
  bool waits() { return wait_-- > 0; }

  /// Length of a step of the lowest n beads, all of whose contacts are closed, by closed formulas from time `start` on;
  /// 0 where it is not worth it. `series_step`: length of a step by Taylor series.
  double begin(const Column<double>& column, const Plate& plate, std::size_t n, std::span<const double> x,
               std::span<const double> u, double start, double series_step);

  /// The beads of the present step; after begin() > 0.
  const RestingCluster& cluster() const { return *resting_; }

 private:
  std::vector<std::unique_ptr<RestingCluster>> clusters_;  ///< of n beads at [n]
  RestingCluster* resting_ = nullptr;
  int tries_ = 0, wait_ = 0;  ///< failed tries, and steps until the next one
};

}  // namespace sigmasweep
