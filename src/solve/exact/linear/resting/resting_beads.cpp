#include "solve/exact/linear/resting/resting_beads.hpp"

#include <algorithm>

namespace sigmasweep {
namespace {

/// A step that goes by RestingCluster is worth this many of the series' steps.
constexpr double worth = 4.0;
constexpr int longest_wait = 16;

}  // namespace

double RestingBeads::begin(const Column<double>& column, const Plate& plate, std::size_t n, std::span<const double> x,
                           std::span<const double> u, double start, double series_step) {
  if (clusters_.size() <= n) clusters_.resize(column.contacts() + 1);
  if (!clusters_[n]) clusters_[n] = std::make_unique<RestingCluster>(column, plate, n);
  RestingCluster& cluster = *clusters_[n];
  const double shortest = worth * series_step;
  const double length = cluster.start(x, u, start) ? cluster.undisturbed(plate.period(), shortest) : 0.0;
  if (length < shortest) {
    tries_ = std::min(2 * tries_ + 1, longest_wait);
    wait_ = tries_;
    return 0.0;
  }
  wait_ = tries_ = 0;
  resting_ = &cluster;
  return length;
}

}  // namespace sigmasweep
