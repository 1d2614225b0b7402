#include "solve/observer/vibration_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sigmasweep {

VibrationStatistics::VibrationStatistics(const Parameters& p, const Column<double>& column, const Plate& plate,
                                         const VibrationUnits& units)
    : plate_(plate),
      units_(units),
      mass_(column.mass.empty() ? std::vector(column.contacts(), 1.0) : column.mass),
      averages_(averages_of(p)),
      x_(column.contacts()),
      u_(column.contacts()) {}

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

void VibrationStatistics::take(double t) {
  if (!measures()) return;
  double z = plate_.height(t), v = 0.0, cm = 0.0, v_cm = 0.0, gaps = 0.0, E_r = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    cm += mass_[i] * (z -= x_[i]);
    v_cm += mass_[i] * (v -= u_[i]);  // relative to the plate
  }
  v = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    v -= u_[i];
    E_r += 0.5 * mass_[i] * (v - v_cm) * (v - v_cm);
  }
  averages_.add(cm, E_r);
  for (std::size_t k = 1; k < x_.size(); ++k) {
    gaps -= x_[k];
    separation_max_ = std::max(separation_max_, -x_[k]);
  }
  if (x_.size() > 1) separation_ += gaps / static_cast<double>(x_.size() - 1);
}

Vibration VibrationStatistics::result() const {
  Vibration v = averages_.result();
  if (averages_.count() > 0.0 && x_.size() > 1) {
    v.separation = separation_ / averages_.count() * units_.length;
    v.separation_max = separation_max_ * units_.length + 0.0;  // never -0
  }
  return v;
}

}  // namespace sigmasweep
