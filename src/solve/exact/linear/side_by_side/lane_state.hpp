#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "solve/exact/linear/side_by_side/lanes/columns.hpp"

namespace sigmasweep::side_by_side {

/// The state of one column out of many: of contact k at [k]. Rates and the clock are in units of the step, disturbances
/// in units of a rounding error.
struct LaneState {
  using Numbers = std::array<double, most_beads>;
  using SmallNumbers = std::array<float, most_beads>;
  struct Disturbance {
    SmallNumbers x, u;
  };

  explicit LaneState(int beads) : N(beads) {
    for (Numbers* const numbers : {&x, &u, &depth}) std::fill_n(numbers->begin(), N, 0.0);
    for (auto& [dx, du] : disturbed)
      for (SmallNumbers* const numbers : {&dx, &du}) std::fill_n(numbers->begin(), N, 0.0F);
    std::fill_n(closed.begin(), N, std::uint8_t(0));
  }

  int N;
  Numbers x, u;
  std::array<Disturbance, disturbances> disturbed;
  std::array<std::uint8_t, most_beads> closed;  ///< as long as the column goes by steps
  Numbers depth;                                ///< these two as in Jumps, as long as it goes by jumps
  double wall_opens = 0.0;
  double clock = 0.0, wall_opened = 0.0, x_max = 0.0;
  std::uint64_t contacts = 0;
  bool separated = false;
};

}  // namespace sigmasweep::side_by_side
