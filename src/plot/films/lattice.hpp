#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Draws a strip of frames (see film_frames()) for each lattice. Beads and walls are to scale. The colour of a bead is
/// its vertical velocity, in units of v0, or in m/s if a plate vibrates. The ends of a periodic container are dotted
/// lines; a bead across them is drawn at both. Single beads that fly very high may be out of view. `differ`, `path` and
/// errors are those of plot_trajectories().
void plot_lattices(std::span<const Panel> panels, std::span<const std::string> differ, const std::string& title,
                   const std::string& path);

/// A frame of a strip.
struct FilmFrame {
  std::size_t sample;
  std::string caption;
};

/// The frames of a film, each sample once. Frames of a collision: the start; the first contact with the bottom; the
/// lowest position of the centre of mass, and the middle between these two; the end, and a third of the way to it.
/// Frames on a plate that vibrates: six phases of the last whole period. Samples after the solver gave up (NaN) are
/// left out.
std::vector<FilmFrame> film_frames(const Panel& panel);

}  // namespace sigmasweep
