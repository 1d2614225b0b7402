#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Draws the reduced heights of all beads against time, a panel with its own axes for each row, as the paper's Fig. 1.
/// Panels go from left to right, `columns` in a line. A vibrated column is drawn with its plate, and time is in
/// periods; with `by_phase` all periods lie on top of each other, as in Fig. 6. `differ` names the parameters that tell
/// panels apart. The ending of `path` (svg, png, pdf) chooses the form. The picture is complete or not there. Throws
/// UsageError (ending, number of panels) and OutputError (gnuplot is missing or fails, `path` cannot be written).
void plot_trajectories(std::span<const Panel> panels, std::size_t columns, std::span<const std::string> differ,
                       const std::string& title, const std::string& path, bool by_phase = false);

}  // namespace sigmasweep
