#include "solve/observer/lattice_statistics.hpp"

#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

namespace sigmasweep {
namespace {

std::vector<double> masses(const Lattice<double>& lattice) {
  std::vector<double> mass;
  for (std::size_t i = 0; i < lattice.count(); ++i) mass.push_back(lattice.mass(i));
  return mass;
}

double total(const std::vector<double>& mass) { return std::accumulate(mass.begin(), mass.end(), 0.0); }

/// Mean number of rows below a bead, weighted by mass.
double rows_below(const Lattice<double>& lattice) {
  double sum = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < lattice.count(); ++i) {
    sum += lattice.mass(i) * static_cast<double>(static_cast<std::int64_t>(i) / lattice.columns);
    mass += lattice.mass(i);
  }
  return sum / mass;
}

constexpr double row_height = std::numbers::sqrt3 / 2.0;  // in lattice constants

}  // namespace

LatticeStatistics::LatticeStatistics(const Parameters& p, const Lattice<double>& lattice, const Plate& plate,
                                     const VibrationUnits& units, MotionBetween motion)
    : plate_(plate),
      mass_(masses(lattice)),
      above_rest_(lattice.beads.gap * (1.0 + rows_below(lattice) * row_height)),
      averages_(p, plate, units, total(mass_),
                lattice.largest * (0.5 + rows_below(lattice) * row_height) * units.length),
      q_(lattice.count()),
      v_(lattice.count()),
      motion_(motion) {
  const double all = total(mass_);
  for (double& m : mass_) m /= all;
}

void LatticeStatistics::take(double t, double share) {
  double height = plate_.height(t) + above_rest_, E_r = 0.0;
  Vec2<double> v_cm;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    height += mass_[i] * q_[i].z;
    v_cm += mass_[i] * v_[i];
  }
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const Vec2<double> v = v_[i] - v_cm;
    E_r += 0.5 * mass_[i] * dot(v, v);
  }
  if (std::exchange(is_first_, false)) averages_.add_stroboscopic(height);
  averages_.add(share, height, E_r);
}

Vibration LatticeStatistics::result() const {
  return averages_.result(midpoint_error(longest_step_ > 0.0 ? plate_.period() / longest_step_ : samples));
}

}  // namespace sigmasweep
