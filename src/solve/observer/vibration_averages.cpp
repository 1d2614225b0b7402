#include "solve/observer/vibration_averages.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace sigmasweep {
namespace {

constexpr std::size_t longest_period = 16, fewest_blocks = 16;

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sum of squared deviations from the mean.
double scatter(std::span<const double> values) {
  const double middle = mean(values);
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [&](double sum, double v) { return sum + (v - middle) * (v - middle); });
}

/// The standard error of the mean of correlated values: the largest standard error of the means of blocks of 1, 2, 4,
/// ... values, down to 16 blocks (H. Flyvbjerg & H. G. Petersen, J. Chem. Phys. 91, 461 (1989)).
double error_of_mean(std::vector<double> values) {
  double largest = Vibration::nan;
  do {
    const auto n = static_cast<double>(values.size());
    if (n > 1.0) largest = std::fmax(largest, std::sqrt(scatter(values) / (n * (n - 1.0))));
    for (std::size_t i = 0; i + 1 < values.size(); i += 2) values[i / 2] = 0.5 * (values[i] + values[i + 1]);
    values.resize(values.size() / 2);
  } while (values.size() >= fewest_blocks);
  return largest;
}

/// The smallest number of periods after which the values, one a period, repeat to within 2 % of their standard
/// deviation or 1e-6 `scale`; 0 if there is none.
std::size_t repeats_after(std::span<const double> values, double scale) {
  constexpr double same = 0.02, still = 1e-6;
  if (values.size() < 2) return 0;
  const double size = std::max(std::sqrt(scatter(values) / static_cast<double>(values.size())) * same, scale * still);
  for (std::size_t lag = 1; lag <= longest_period && 2 * lag <= values.size(); ++lag) {
    double sum = 0.0;
    for (std::size_t k = lag; k < values.size(); ++k)
      sum += (values[k] - values[k - lag]) * (values[k] - values[k - lag]);
    if (std::sqrt(sum / static_cast<double>(values.size() - lag)) <= size) return lag;
  }
  return 0;
}

}  // namespace

VibrationAverages::VibrationAverages(const Parameters& p, const Plate& plate, const VibrationUnits& units,
                                     double total_mass, double rest_height)
    : plate_(plate),
      units_(units),
      total_mass_(total_mass),
      rest_height_(rest_height),
      periods_(p.periods),
      transient_(p.transient) {}

void VibrationAverages::add(double share, double height, double E_r) {
  height_ += share * height;
  E_r_ += share * E_r;
}

void VibrationAverages::add_stroboscopic(double height) { stroboscopic_.push_back(height); }

void VibrationAverages::end_period(double energy, double in, double lost) {
  now_ = {energy, in, lost};
  if (measures()) heights_.push_back(height_);
  height_ = 0.0;
  ++period_;
  if (period_ == transient_) start_ = now_;
}

Vibration VibrationAverages::result(double integration_error) const {
  Vibration v;
  if (heights_.empty()) return v;
  const auto periods = static_cast<double>(heights_.size());
  const double speed2 = units_.speed() * units_.speed();
  const double height = mean(heights_), of_integration = integration_error * (plate_.A0 + std::fabs(height));
  v.h_cm_excess = height * units_.length;
  v.h_cm = rest_height_ + v.h_cm_excess;
  v.h_cm_error = std::fmax(error_of_mean(heights_), of_integration) * units_.length;
  v.E_r = E_r_ / count() * speed2;
  if (const std::size_t lag = repeats_after(stroboscopic_, plate_.A0); lag > 0)
    v.cm_period = static_cast<double>(lag) * plate_.period() * units_.time;
  const double in = now_.in - start_.in, lost = now_.lost - start_.lost;
  const double to_power = speed2 / (total_mass_ * periods * plate_.period() * units_.time);
  v.power_in = in * to_power;
  v.power_lost = lost * to_power;
  const double path = 4.0 * plate_.A0 * periods;  // of the plate
  v.imbalance = (in - lost - (now_.energy - start_.energy)) / std::max(std::fabs(in), total_mass_ * plate_.g * path);
  return v;
}

}  // namespace sigmasweep
