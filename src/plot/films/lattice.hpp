#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Draws lattices, a strip of pictures each (film_frames()): all beads and walls to scale, coloured by how fast they go
/// up or down, in v0, or in m/s if anything vibrates. Beads that stick out of a periodic container are drawn at both of
/// its ends, which are dotted lines; single beads that fly very high may be left out. `differ`, `path` and errors as of
/// plot_trajectories().
void plot_lattices(std::span<const Panel> panels, std::span<const std::string> differ, const std::string& title,
                   const std::string& path);

/// A picture of a strip.
struct FilmFrame {
  std::size_t sample;
  std::string what;
};

/// Of a flight: the start; the first contact with the bottom; when the centre of mass is lowest, and halfway there; the
/// end, and a third of the way there. Where a plate vibrates: six phases of the last whole period. Samples that are the
/// same are left out, so are those where there is nothing (NaN).
std::vector<FilmFrame> film_frames(const Panel& panel);

}  // namespace sigmasweep
