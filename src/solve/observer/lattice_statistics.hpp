#pragma once

#include <span>
#include <vector>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "base/vec2.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/observer/vibration_averages.hpp"

namespace sigmasweep {

/// Watches a vibrated lattice as VibrationStatistics does a column. At rest the lattice is closed.
class LatticeStatistics {
 public:
  static constexpr bool observes = true;

  LatticeStatistics(const Parameters& parameters, const Lattice<double>& lattice, const Plate& plate,
                    const VibrationUnits& units);

  /// `state(t, q, v)` fills in displacements from the sites and velocities of all beads, relative to the plate.
  template <class State>
  void until(double time, State&& state) {
    averages_.until(time, [&](double t) {
      state(t, std::span(q_), std::span(v_));
      take(t);
    });
  }
  void end_period(double energy, double in, double lost) { averages_.end_period(energy, in, lost); }
  bool done() const { return averages_.done(); }

  /// NaN where not even one period was measured; without separations.
  Vibration result() const { return averages_.result(); }

 private:
  void take(double t);

  Plate plate_;
  std::vector<double> mass_;  ///< over the lattice's
  double above_rest_ = 0.0;   ///< the centre of mass of the sites
  VibrationAverages averages_;
  std::vector<Vec2<double>> q_, v_;
};

}  // namespace sigmasweep
