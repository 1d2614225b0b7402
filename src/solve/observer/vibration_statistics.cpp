#include "solve/observer/vibration_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sigmasweep {
namespace {

/// The largest value of Hermite's cubic on [0, 1] that rises at 0 and falls at 1. Derivatives: c1 + 2 c2 s + 3 c3 s^2.
double largest_between(double x0, double rise, double x1, double fall) {
  const double d = x1 - x0, c1 = rise, c2 = 3.0 * d - 2.0 * rise - fall, c3 = rise + fall - 2.0 * d;
  const double s = c1 / (std::sqrt(std::max(c2 * c2 - 3.0 * c1 * c3, 0.0)) - c2);
  return x0 + s * (c1 + s * (c2 + s * c3));
}

}  // namespace

VibrationStatistics::VibrationStatistics(const Parameters& p, const Column<double>& column, const Plate& plate,
                                         const VibrationUnits& units, MotionBetween motion)
    : plate_(plate),
      units_(units),
      motion_(motion),
      mass_(column.mass.empty() ? std::vector(column.contacts(), 1.0) : column.mass),
      averages_(averages_of(p)),
      x_(column.contacts()),
      u_(column.contacts()),
      x_before_(column.contacts()),
      u_before_(column.contacts()) {}

/// The averages of a column. Also divides the masses by the column's.
VibrationAverages VibrationStatistics::averages_of(const Parameters& p) {
  const double total = std::accumulate(mass_.begin(), mass_.end(), 0.0);
  double rest_height = 0.0, below = 0.0;
  for (double& m : mass_) {
    const double diameter = p.d * std::cbrt(m);
    m /= total;
    rest_height += m * (below + 0.5 * diameter);
    below += diameter;
  }
  return {p, plate_, units_, total, rest_height};
}

/// On an eighth of a period the rule of 6 places is off by 1e-14 A0 for z0(t) = A0 sin 2 pi f t. Heights in flight are
/// parabolas, for which that of 3 is exact; for z0(t), on which beads may rest, it is as good on short pieces.
std::span<const QuadratureNode> VibrationStatistics::nodes_until(double time) {
  constexpr double longest = 1.0 / 8.0, shortest = 1.0 / 512.0;  // in periods
  const double length = time - from_, period = plate_.period();
  nodes_.clear();
  if (motion_ == MotionBetween::steps) {
    longest_step_ = std::max(longest_step_, length);
    nodes_.push_back({from_ + 0.5 * length, length / period});
  } else if (motion_ == MotionBetween::flights && length <= shortest * period) {
    add_nodes(lobatto3, from_, time);
  } else {
    const int pieces = static_cast<int>(std::ceil(length / (longest * period)));
    for (int i = 0; i < pieces; ++i)
      add_nodes(lobatto6, from_ + i * length / pieces, i + 1 == pieces ? time : from_ + (i + 1) * length / pieces);
  }
  return nodes_;
}

void VibrationStatistics::add_nodes(std::span<const QuadratureNode> rule, double from, double to) {
  const double length = to - from, share = length / plate_.period();
  for (const auto& [place, weight] : rule) nodes_.push_back({place < 1.0 ? from + place * length : to, weight * share});
}

/// Of the centre of mass, above its height at rest.
double VibrationStatistics::height(double t) const {
  double z = plate_.height(t), cm = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) cm += mass_[i] * (z -= x_[i]);
  return cm;
}

void VibrationStatistics::take(double t, double share) {
  double v = 0.0, v_cm = 0.0, gaps = 0.0, E_r = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) v_cm += mass_[i] * (v -= u_[i]);  // relative to the plate
  v = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    v -= u_[i];
    E_r += 0.5 * mass_[i] * (v - v_cm) * (v - v_cm);
  }
  averages_.add(share, height(t), E_r);
  for (std::size_t k = 1; k < x_.size(); ++k) gaps -= x_[k];
  look_for_widest_gap(t);
  if (x_.size() > 1) separation_ += share * gaps / static_cast<double>(x_.size() - 1);
}

void VibrationStatistics::look_for_widest_gap(double t) {
  const double elapsed = t - before_;  // not positive at the start of a period
  for (std::size_t k = 1; k < x_.size(); ++k) {
    double widest = -x_[k];
    if (elapsed > 0.0 && u_before_[k] < 0.0 && u_[k] > 0.0)
      widest = largest_between(-x_before_[k], -u_before_[k] * elapsed, -x_[k], -u_[k] * elapsed);
    separation_max_ = std::max(separation_max_, widest);
  }
  before_ = t;
  x_before_ = x_;
  u_before_ = u_;
}

Vibration VibrationStatistics::result() const {
  constexpr double of_events = 1e-12;  // times of events and roundings
  const bool has_steps = motion_ == MotionBetween::steps && longest_step_ > 0.0;
  Vibration v = averages_.result(has_steps ? midpoint_error(plate_.period() / longest_step_) : of_events);
  if (averages_.count() > 0.0 && x_.size() > 1) {
    v.separation = separation_ / averages_.count() * units_.length;
    v.separation_max = separation_max_ * units_.length + 0.0;  // never -0
  }
  return v;
}

}  // namespace sigmasweep
