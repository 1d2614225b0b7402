#pragma once

#include <limits>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/observer/vibration_averages.hpp"

namespace sigmasweep {

/// The observer that averages over a vibrated column, in the solver's units. See VibrationAverages.
class VibrationStatistics {
 public:
  static constexpr bool observes = true;
  static constexpr int samples = VibrationAverages::samples;  ///< per period

  VibrationStatistics(const Parameters& parameters, const Column<double>& column, const Plate& plate,
                      const VibrationUnits& units);

  /// Takes the samples up to and at `time`, within the period. `state(t, x, u)` writes the overlaps x and rates u of
  /// all contacts; the first one is that with the plate.
  template <class State>
  void until(double time, State&& state) {
    averages_.until(time, [&](double t) {
      state(t, std::span(x_), std::span(u_));
      take(t);
    });
  }
  void end_period(double energy, double in, double lost) { averages_.end_period(energy, in, lost); }
  bool done() const { return averages_.done(); }
  bool measures() const { return averages_.measures(); }

  /// The averages; NaN if no period was measured.
  Vibration result() const;

 private:
  void take(double t);
  VibrationAverages averages_of(const Parameters& parameters);

  Plate plate_;
  VibrationUnits units_;
  std::vector<double> mass_;  ///< as fractions of the column's
  VibrationAverages averages_;
  std::vector<double> x_, u_;
  double separation_ = 0.0;  ///< sum over all samples
  double separation_max_ = -std::numeric_limits<double>::infinity();
};

}  // namespace sigmasweep
