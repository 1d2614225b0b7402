#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"

namespace sigmasweep {

/// A collision to draw.
struct Panel {
  Row row;
  Trajectory trajectory;
};

/// How many panels find room on a picture. Throws UsageError for more, or none.
inline constexpr std::size_t max_panels = 24;
void require_room_for(std::size_t panels);

/// Draws the reduced heights of all beads against time, a panel for each collision, as the paper's Fig. 1: panels from
/// left to right, `columns` in a line, each with its own axes. Of vibrated columns also the plate; time is in its
/// periods there, or with `by_phase` all periods lie on top of each other, as in Fig. 6. `differ` names the parameters
/// that tell panels apart. The ending of `path` (svg, png, pdf) chooses the form. The picture is complete or not there.
/// Throws UsageError (ending, number of panels), OutputError (gnuplot missing or failing, `path` cannot be written).
void plot_trajectories(std::span<const Panel> panels, std::size_t columns, std::span<const std::string> differ,
                       const std::string& title, const std::string& path, bool by_phase = false);

}  // namespace sigmasweep
