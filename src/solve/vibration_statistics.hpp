#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plate.hpp"
#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/solve/column.hpp"

namespace sigmasweep {

/// Watches a vibrated column, in the solver's units, and averages what it sees over the periods after the transient, at
/// moments evenly spread over each period. Solvers keep time within the present period of the plate, and say when it is
/// over: the phase is as exact after 10,000 periods as in the first.
class VibrationStatistics {
 public:
  static constexpr bool watches = true;
  static constexpr int samples = 256;  ///< a period

  VibrationStatistics(const Parameters& parameters, const Column<double>& column, const Plate& plate,
                      const VibrationUnits& units);

  /// Takes the samples up to and at `time`, within the period, by `state(t, x, u)`, which fills in the overlaps x of
  /// all contacts (the plate's is the first; gaps are negative) and their rates u.
  template <class State>
  void until(double time, State&& state) {
    for (; taken_ < samples && moment(taken_) <= time; ++taken_) {
      state(moment(taken_), std::span(x_), std::span(u_));
      take(moment(taken_));
    }
  }
  /// A period is over, and the clock is back at 0. `energy`: by how much that of the column has grown since the start,
  /// kinetic (in the room's frame), of gravity and elastic; `in` and `lost`: the plate's work and what contacts lost
  /// since then; in the solver's units with mass 1 for the mean bead.
  void end_period(double energy, double in, double lost);
  /// Whether all periods are over.
  bool done() const { return period_ == periods_; }
  bool measures() const { return period_ >= transient_; }

  /// NaN where not even one period was measured.
  Vibration result() const;

 private:
  double moment(int sample) const { return plate_.period() * (sample + 0.5) / samples; }
  void take(double t);

  struct Books {
    double energy = 0.0, in = 0.0, lost = 0.0;
  };

  Plate plate_;
  VibrationUnits units_;
  std::vector<double> mass_;        ///< over the column's
  double total_mass_, rest_height_; ///< in mean beads; m
  std::int64_t periods_, transient_, period_ = 0;
  int taken_ = 0;
  std::vector<double> x_, u_;
  double height_ = 0.0;                    ///< of the centre of mass over its rest, sum of this period's samples
  std::vector<double> heights_, stroboscopic_;  ///< a period's mean; at its first sample
  double separation_ = 0.0, E_r_ = 0.0;    ///< sums over all samples
  double separation_max_ = -std::numeric_limits<double>::infinity();
  Books start_, now_;
};

}  // namespace sigmasweep
