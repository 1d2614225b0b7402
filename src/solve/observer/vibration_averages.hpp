#pragma once

#include <cstdint>
#include <vector>

#include "assembly/ground.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// Averages of whatever vibrates over the periods after the transient, at moments evenly spread over each period; and
/// the books of its energy. Solvers keep time within the present period of the plate, and say when it is over: the
/// phase is as exact after 10,000 periods as in the first.
class VibrationAverages {
 public:
  static constexpr int samples = 256;  ///< a period

  /// In the solver's units with mass 1 for the mean bead; `rest_height`: of the centre of mass, m.
  VibrationAverages(const Parameters& parameters, const Plate& plate, const VibrationUnits& units, double total_mass,
                    double rest_height);

  /// Calls take(t) for the moments up to and at `time`, within the period.
  template <class Take>
  void until(double time, Take&& take) {
    for (; taken_ < samples && moment(taken_) <= time; ++taken_) take(moment(taken_));
  }
  /// Of one moment, within until(): height of the centre of mass over its rest, and the kinetic energy relative to it
  /// over the mass.
  void add(double height, double E_r);
  /// A period is over, and the clock is back at 0. `energy`: by how much that of all has grown since the start, kinetic
  /// (in the room's frame), of gravity and elastic; `in` and `lost`: the plate's work and what contacts lost since
  /// then.
  void end_period(double energy, double in, double lost);
  /// Whether all periods are over.
  bool done() const { return period_ == periods_; }
  bool measures() const { return period_ >= transient_; }

  /// How many moments were measured in periods that are over.
  double count() const { return static_cast<double>(heights_.size()) * samples; }
  /// Without separations. NaN where not even one period was measured.
  Vibration result() const;

 private:
  double moment(int sample) const { return plate_.period() * (sample + 0.5) / samples; }

  struct Books {
    double energy = 0.0, in = 0.0, lost = 0.0;
  };

  Plate plate_;
  VibrationUnits units_;
  double total_mass_, rest_height_;  ///< in mean beads; m
  std::int64_t periods_, transient_, period_ = 0;
  int taken_ = 0;
  double height_ = 0.0;                         ///< of the centre of mass over its rest, sum of this period's samples
  std::vector<double> heights_, stroboscopic_;  ///< a period's mean; at its first sample
  double E_r_ = 0.0;                            ///< sum over all samples
  Books start_, now_;
};

}  // namespace sigmasweep
