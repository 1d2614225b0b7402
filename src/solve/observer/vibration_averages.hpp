#pragma once

#include <cstdint>
#include <vector>

#include "assembly/ground.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// Averages of a vibrated column or lattice over the periods after the transient, from samples that are evenly spread
/// over each period, and its energy balance. Solvers count time from the start of the plate's present period, so that
/// the phase is as exact after 10,000 periods as in the first.
class VibrationAverages {
 public:
  static constexpr int samples = 256;  ///< per period

  /// In the solver's units, with the mean bead's mass as unit. `rest_height` is that of the centre of mass, m.
  VibrationAverages(const Parameters& parameters, const Plate& plate, const VibrationUnits& units, double total_mass,
                    double rest_height);

  /// Calls take(t) for the times of samples up to and at `time`, within the period.
  template <class Take>
  void until(double time, Take&& take) {
    for (; taken_ < samples && moment(taken_) <= time; ++taken_) take(moment(taken_));
  }
  /// Adds a sample, within until(): the height of the centre of mass above its height at rest, and the kinetic energy
  /// relative to the centre of mass per mass.
  void add(double height, double E_r);
  /// Ends a period; the next one starts at time 0. `energy` is the increase since the start of the kinetic energy (in
  /// the frame at rest), the potential energy in gravity and the elastic energy; `in` the work of the plate and `lost`
  /// the energy dissipated in contacts since the start.
  void end_period(double energy, double in, double lost);
  /// Whether all periods are over.
  bool done() const { return period_ == periods_; }
  bool measures() const { return period_ >= transient_; }

  /// Number of samples in the measured periods.
  double count() const { return static_cast<double>(heights_.size()) * samples; }
  /// The averages, without separations; NaN if no period was measured.
  Vibration result() const;

 private:
  double moment(int sample) const { return plate_.period() * (sample + 0.5) / samples; }

  struct Books {
    double energy = 0.0, in = 0.0, lost = 0.0;
  };

  Plate plate_;
  VibrationUnits units_;
  double total_mass_, rest_height_;  ///< in masses of the mean bead; m
  std::int64_t periods_, transient_, period_ = 0;
  int taken_ = 0;
  double height_ = 0.0;                         ///< sum of the heights of this period's samples
  std::vector<double> heights_, stroboscopic_;  ///< for each period the mean height; the height at the first sample
  double E_r_ = 0.0;                            ///< sum over all samples
  Books start_, now_;
};

}  // namespace sigmasweep
