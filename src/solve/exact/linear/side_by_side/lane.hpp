#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "assembly/column.hpp"
#include "base/random.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/exact/linear/side_by_side/lane_law.hpp"
#include "solve/exact/linear/side_by_side/lane_state.hpp"

namespace sigmasweep::side_by_side {

/// What one column is beside its state: the law, the random numbers of its disturbance, and its looks at what is left
/// to dissipate. The same code for every width.
class Lane {
 public:
  explicit Lane(const Parameters& parameters);

  const LaneLaw& law() const { return *law_; }
  /// By jumps, unless beads touch.
  LaneState start() const;
  bool starts_by_jumps() const;
  const Isolated& isolated() const { return law_->isolated; }
  /// 1/m of the bead above contact k.
  double inverse_mass(int k) const { return law_->isolated.contact(k).inverse_mass; }
  /// The sign of the rounding error of contact k's restitution in disturbance d.
  double sign(int d, int k) const { return random_bits(~key_, static_cast<std::uint64_t>(d)) >> k & 1 ? 1.0 : -1.0; }

  void next_step() { ++steps_; }
  /// Random bits for this step and disturbance d, for 32 contacts: 32 for overlaps and 32 for rates.
  std::uint64_t noise(int d, int word) const {
    return random_bits(key_, (words_of_noise * steps_ + static_cast<std::uint64_t>(word)) * disturbances +
                                 static_cast<std::uint64_t>(d));
  }
  /// Whether it is time for a look, or to give up.
  bool is_due(std::uint64_t contacts) const { return contacts >= next_look_ || steps_ >= step_limit_; }
  /// Whether a look would be of use, where one is due; `approach` is the largest rate at which an overlap grows. If
  /// not, it counts as done.
  bool wants_look(std::uint64_t contacts, double approach);
  /// Whether this column, going by steps, has come to an end, settled or given up.
  bool ends(const LaneState& state);
  /// Status::ok with its error bar, or Status::event_limit: the column must be computed in another way.
  SimulationResult result(const LaneState& state);

 private:
  struct Balance {
    double disturbance = 0.0, remaining = 0.0;          ///< of sqrt(E/E_0)
    double distance = 0.0, ahead = 0.0, present = 0.0;  ///< of velocities, as in ExactColumn
  };
  Balance balance(const LaneState& state) const;
  std::uint64_t look_after(std::uint64_t contacts) const { return (contacts / between_looks_ + 1) * between_looks_; }
  /// A look at the state: its error bars count if they are the smallest so far.
  void note(const Balance& now);

  Parameters parameters_;
  Column<double> column_;
  std::shared_ptr<const LaneLaw> law_;
  std::uint64_t key_;  ///< of the random numbers
  std::uint64_t steps_ = 0, step_limit_, between_looks_, next_look_;
  double settle_;
  double least_loss_ = 0.0;  ///< of |v|^2 over the initial one where beads approach by 1
  /// The smallest error bars that a look has found, of eps_eff and of the velocities.
  double least_ = std::numeric_limits<double>::infinity(), least_of_velocity_ = least_;
  bool settled_ = false;
};

}  // namespace sigmasweep::side_by_side
