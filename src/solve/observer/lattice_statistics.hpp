#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "base/vec2.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/observer/vibration_averages.hpp"

namespace sigmasweep {

/// The observer that averages over a vibrated lattice: over fixed steps as VibrationStatistics does, otherwise over
/// samples that are evenly spread over each period, as a quadrature between its very many contacts would cost more than
/// its motion. At rest all contacts of the lattice are closed.
class LatticeStatistics {
 public:
  static constexpr bool observes = true;
  static constexpr int samples = 256;  ///< per period

  LatticeStatistics(const Parameters& parameters, const Lattice<double>& lattice, const Plate& plate,
                    const VibrationUnits& units, MotionBetween motion);

  /// The motion up to `time`, within the period, since the last call. `state(t, q, v)` writes displacements from the
  /// sites and velocities of all beads, relative to the plate.
  template <class State>
  void until(double time, State&& state) {
    const auto look = [&](double t, double share) {
      if (!averages_.measures()) return;
      state(t, std::span(q_), std::span(v_));
      take(t, share);
    };
    if (motion_ == MotionBetween::steps && time > from_) {
      longest_step_ = std::max(longest_step_, time - from_);
      look(0.5 * (from_ + time), (time - from_) / plate_.period());
    }
    from_ = time;
    if (motion_ == MotionBetween::steps) return;
    for (; taken_ < samples && moment(taken_) <= time; ++taken_) look(moment(taken_), 1.0 / samples);
  }
  void end_period(double energy, double in, double lost) {
    averages_.end_period(energy, in, lost);
    taken_ = 0;
    from_ = 0.0;
    is_first_ = true;
  }
  bool done() const { return averages_.done(); }

  /// The averages, without separations; NaN if no period was measured.
  Vibration result() const;

 private:
  double moment(int sample) const { return plate_.period() * (sample + 0.5) / samples; }
  void take(double t, double share);

  Plate plate_;
  std::vector<double> mass_;  ///< as fractions of the lattice's
  double above_rest_ = 0.0;   ///< height of the sites' centre of mass above its height at rest
  VibrationAverages averages_;
  std::vector<Vec2<double>> q_, v_;
  MotionBetween motion_;
  int taken_ = 0;              ///< samples of this period
  double from_ = 0.0;          ///< time of the last call
  double longest_step_ = 0.0;  ///< MotionBetween::steps
  bool is_first_ = true;       ///< look at the period
};

}  // namespace sigmasweep
