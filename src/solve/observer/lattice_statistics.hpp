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

/// The observer that averages over a vibrated lattice, as VibrationStatistics does over a column. At rest all contacts
/// of the lattice are closed.
class LatticeStatistics {
 public:
  static constexpr bool observes = true;

  LatticeStatistics(const Parameters& parameters, const Lattice<double>& lattice, const Plate& plate,
                    const VibrationUnits& units);

  /// Takes the samples up to and at `time`, within the period. `state(t, q, v)` writes displacements from the sites and
  /// velocities of all beads, relative to the plate.
  template <class State>
  void until(double time, State&& state) {
    averages_.until(time, [&](double t) {
      state(t, std::span(q_), std::span(v_));
      take(t);
    });
  }
  void end_period(double energy, double in, double lost) { averages_.end_period(energy, in, lost); }
  bool done() const { return averages_.done(); }

  /// The averages, without separations; NaN if no period was measured.
  Vibration result() const { return averages_.result(); }

 private:
  void take(double t);

  Plate plate_;
  std::vector<double> mass_;  ///< as fractions of the lattice's
  double above_rest_ = 0.0;   ///< height of the sites' centre of mass above its height at rest
  VibrationAverages averages_;
  std::vector<Vec2<double>> q_, v_;
};

}  // namespace sigmasweep
