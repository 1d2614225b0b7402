#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "assembly/column.hpp"
#include "contact/linear_pair.hpp"
#include "solve/exact/linear/side_by_side/lane_state.hpp"

namespace sigmasweep::side_by_side {

/// A contact whose partners touch nothing else, in units of the step.
struct IsolatedContact {
  BinaryContact<double> law;
  double dashpot, inertia;          ///< C h and 1/m_red
  double inverse_mass;              ///< of the bead above
  double share_below, share_above;  ///< what the gap on either side receives of a change of this one, but the sign
  double restitution, duration;     ///< of the whole contact
  double deepest;                   ///< largest overlap if it closes at unit rate
};

/// Takes a column from steps to jumps and back: closed contacts become busy ones, and busy ones closed (jump_impl.hpp).
class Isolated {
 public:
  /// `step`: the unit of time. In long double, as all contacts share the rounding errors of their constants.
  Isolated(const Column<long double>& column, double step);

  /// Of contact k; where all beads are equal, of the wall's contact 0 and of pairs.
  const IsolatedContact& contact(int k) const { return contacts_[std::min(static_cast<std::size_t>(k), last_)]; }
  /// A test that costs next to nothing, of a column whose closed contacts are no neighbours: whether the gaps beside
  /// them surely stay open. Contact k has overlap x[k stride] and rate u[k stride].
  bool may_jump(const double* x, const double* u, int stride, int N, std::uint64_t closed) const;
  /// False, and a state without a meaning, if something will disturb a closed contact.
  bool to_jumps(LaneState& state) const;
  void to_steps(LaneState& state) const;

 private:
  bool close_at_once(LaneState& state, int k, LaneState::Numbers& busy_until) const;
  void put_back(LaneState& state, int k) const;

  std::vector<IsolatedContact> contacts_;
  std::size_t last_;
};

}  // namespace sigmasweep::side_by_side
