#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "numerics/lobatto.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/observer/vibration_averages.hpp"

namespace sigmasweep {

/// The observer that averages over a vibrated column, in the solver's units. Averages are integrals over the motion
/// from each call to the next one. Within fixed steps the midpoint rule is as good as the steps are.
class VibrationStatistics {
 public:
  static constexpr bool observes = true;

  VibrationStatistics(const Parameters& parameters, const Column<double>& column, const Plate& plate,
                      const VibrationUnits& units, MotionBetween motion);

  /// The motion up to `time`, within the period, since the last call. `state(t, x, u)` writes the overlaps x and rates
  /// u of all contacts at a time in between or at an end; the first contact is that with the plate.
  template <class State>
  void until(double time, State&& state) {
    if (!(time > from_)) return;
    if (averages_.measures()) {
      if (from_ == 0.0) {
        state(0.0, std::span(x_), std::span(u_));
        averages_.add_stroboscopic(height(0.0));
      }
      for (const QuadratureNode& node : nodes_until(time)) {
        state(node.place, std::span(x_), std::span(u_));
        take(node.place, node.weight);
      }
    }
    from_ = time;
  }
  void end_period(double energy, double in, double lost) {
    averages_.end_period(energy, in, lost);
    from_ = 0.0;
  }
  bool done() const { return averages_.done(); }

  /// The averages; NaN if no period was measured.
  Vibration result() const;

 private:
  VibrationAverages averages_of(const Parameters& parameters);
  /// Times from the last call until `time`, each with its share of the period.
  std::span<const QuadratureNode> nodes_until(double time);
  void add_nodes(std::span<const QuadratureNode> rule, double from, double to);
  double height(double t) const;
  void take(double t, double share);
  void look_for_widest_gap(double t);

  Plate plate_;
  VibrationUnits units_;
  MotionBetween motion_;
  std::vector<double> mass_;  ///< as fractions of the column's
  VibrationAverages averages_;
  std::vector<double> x_, u_;
  double before_ = 0.0;  ///< time of the last place
  std::vector<double> x_before_, u_before_;
  double from_ = 0.0;                  ///< time of the last call
  std::vector<QuadratureNode> nodes_;  ///< of the present call
  double longest_step_ = 0.0;          ///< MotionBetween::steps
  double separation_ = 0.0;            ///< sum of the means of all periods
  double separation_max_ = -std::numeric_limits<double>::infinity();
};

}  // namespace sigmasweep
