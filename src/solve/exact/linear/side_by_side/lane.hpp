#pragma once

#include <array>
#include <cstdint>

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/exact/linear/side_by_side/columns.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep::side_by_side {

/// The state of one column out of many: of contact k at [k]. Rates and the clock are in units of the step.
struct LaneState {
  using Numbers = std::array<double, most_beads>;
  Numbers x{}, u{}, dx{}, du{};
  std::array<std::uint8_t, most_beads> closed{};
  double clock = 0.0, wall_opened = 0.0, x_max = 0.0;
  std::uint64_t contacts = 0;
  bool separated = false;
};

/// What one column is beside its state: the law, the random numbers of its disturbance, and its looks at what is left
/// to dissipate. The same code for every width.
class Lane {
 public:
  explicit Lane(const Parameters& parameters);

  /// K h^2 and C h: springs and dashpots in the lane's unit of time.
  double spring() const { return column_.K * step_ * step_; }
  double dashpot() const { return column_.C * step_; }
  double wall_spring() const { return column_.K_wall * step_ * step_; }
  double wall_dashpot() const { return column_.C_wall * step_; }
  LaneState start() const;

  /// Random bits for the next step.
  std::uint64_t noise();
  /// Whether a look is due, or the lane has to give up.
  bool is_due(std::uint64_t contacts) const { return contacts >= next_look_ || steps_ >= step_limit_; }
  /// Whether this column has come to an end, settled or given up.
  bool ends(const LaneState& state);
  /// Status::ok with its error bar, or Status::event_limit: the column must be computed in another way.
  SimulationResult result(const LaneState& state);

 private:
  struct Balance {
    double disturbance = 0.0, remaining = 0.0;
  };
  Balance balance(const LaneState& state) const;

  Parameters parameters_;
  Column<double> column_;
  double step_;        ///< h, in t_c
  std::uint64_t key_;  ///< of the random numbers
  std::uint64_t steps_ = 0, step_limit_, next_look_;
  double settle_, least_;  ///< least: the smallest error bar that a look has found
  bool settled_ = false;
};

}  // namespace sigmasweep::side_by_side
