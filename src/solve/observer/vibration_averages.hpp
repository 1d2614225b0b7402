#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "assembly/ground.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// What happens between two calls of an observer's until().
enum class MotionBetween {
  flights,   ///< of hard spheres
  contacts,  ///< soft spheres move, smoothly
  steps,     ///< a fixed step
};

/// Averages of a vibrated column or lattice over the time of the periods after the transient, and its energy balance.
/// Solvers count time from the start of the plate's present period, so that
/// the phase is as exact after 10,000 periods as in the first.
class VibrationAverages {
 public:
  /// In the solver's units, with the mean bead's mass as unit. `rest_height` is that of the centre of mass, m.
  VibrationAverages(const Parameters& parameters, const Plate& plate, const VibrationUnits& units, double total_mass,
                    double rest_height);

  /// Adds a place of a quadrature rule, which stands for this share of the period: the height of the centre of mass
  /// above its height at rest, and the kinetic energy relative to the centre of mass per mass.
  void add(double share, double height, double E_r);
  /// The height at a phase that is the same in all periods.
  void add_stroboscopic(double height);
  /// Ends a period; the next one starts at time 0. `energy` is the increase since the start of the kinetic energy (in
  /// the frame at rest), the potential energy in gravity and the elastic energy; `in` the work of the plate and `lost`
  /// the energy dissipated in contacts since the start.
  void end_period(double energy, double in, double lost);
  /// Whether all periods are over.
  bool done() const { return period_ == periods_; }
  bool measures() const { return period_ >= transient_; }

  /// Number of measured periods.
  double count() const { return static_cast<double>(heights_.size()); }
  /// The averages, without separations; NaN if no period was measured. `integration_error`: of the mean of a height, in
  /// units of its scale. In periodic motion nothing else is left of h_cm_error.
  Vibration result(double integration_error) const;

 private:
  struct Books {
    double energy = 0.0, in = 0.0, lost = 0.0;
  };

  Plate plate_;
  VibrationUnits units_;
  double total_mass_, rest_height_;  ///< in masses of the mean bead; m
  std::int64_t periods_, transient_, period_ = 0;
  double height_ = 0.0;                         ///< this period's mean so far
  std::vector<double> heights_, stroboscopic_;  ///< of each period the mean, and one height
  double E_r_ = 0.0;                            ///< sum of the means of all periods
  Books start_, now_;
};

/// Error of the mean of a height by the midpoint rule with so many places a period, over the height's amplitude: h^2/24
/// times the second derivative.
constexpr double midpoint_error(double places) {
  const double width = 2.0 * std::numbers::pi / places;
  return width * width / 24.0;
}

}  // namespace sigmasweep
