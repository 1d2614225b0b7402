#pragma once

#include "assembly/column.hpp"
#include "contact/linear_pair.hpp"
#include "solve/exact/linear/side_by_side/lane_state.hpp"

namespace sigmasweep::side_by_side {

/// Of an isolated contact: restitution, contact time, and largest overlap if it closes at unit rate.
struct ContactTimes {
  double restitution = 0.0, duration = 0.0, deepest = 0.0;
};

/// Takes a column from steps to jumps and back: closed contacts become busy ones, and busy ones closed (jump_impl.hpp).
class Isolated {
 public:
  /// `step`: the unit of time. In long double, as all contacts share the rounding errors of their constants.
  Isolated(const Column<long double>& column, double step);

  const ContactTimes& times(bool wall) const { return wall ? at_wall_ : of_pair_; }
  /// A test that costs next to nothing, of a column whose closed contacts are no neighbours: whether the gaps beside
  /// them surely stay open. Contact k has overlap x[k stride] and rate u[k stride].
  bool may_jump(const double* x, const double* u, int stride, int N, std::uint64_t closed) const;
  /// False, and a state without a meaning, if something will disturb a closed contact.
  bool to_jumps(LaneState& state) const;
  void to_steps(LaneState& state) const;

 private:
  const BinaryContact<double>& contact(int k) const { return k == 0 ? wall_ : pair_; }
  bool close_at_once(LaneState& state, int k, LaneState::Numbers& busy_until) const;
  void put_back(LaneState& state, int k) const;

  BinaryContact<double> pair_, wall_;
  ContactTimes of_pair_, at_wall_;
  double dashpot_, wall_dashpot_;
};

}  // namespace sigmasweep::side_by_side
