#pragma once

#include <cstddef>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"

namespace sigmasweep {

/// A panel of a picture: a row of a table and the trajectory of its beads.
struct Panel {
  Row row;
  Trajectory trajectory;
};

/// Whether the beads are on a plate that vibrates.
bool has_plate(const Panel& panel);

/// The most panels that a picture has room for.
inline constexpr std::size_t max_panels = 24;

/// Throws UsageError for no panels, or more than max_panels.
void require_room_for(std::size_t panels);

}  // namespace sigmasweep
